// SPDX-License-Identifier: Apache-2.0
#include "studio/jobs/job_keeper.hpp"

#include "ionskin/base/files/atomic_file.hpp"
#include "ionskin/base/system/processes.hpp"
#include "studio/jobs/confinement.hpp"
#include "studio/jobs/job.hpp"

#include <csignal>
#include <ctime>
#include <fcntl.h>
#include <unistd.h>

namespace ionskin::apps::studio {
namespace {

/// Runs the command and returns its exit code. It runs in this process group, receives the signals
/// that the keeper ignores, and is confined to the working folder, the workspace.
int run(const std::vector<std::string>& words) {
  std::vector<std::string> all{program().string()};
  all.insert(all.end(), words.begin(), words.end());
  const std::vector<char*> pointers = base::argument_pointers(all);
  const Confinement confinement(
      base::FileDescriptor(::open(".", O_PATH | O_DIRECTORY | O_CLOEXEC)));
  const pid_t child = fork();
  if (child == 0) {
    std::signal(SIGINT, SIG_DFL);
    std::signal(SIGTERM, SIG_DFL);
    if (confinement.enter()) {
      execv(pointers[0], pointers.data());
    }
    _exit(127);
  }
  const int status = child < 0 ? 127 : base::wait_for_end(child);
  return status < 0 ? 128 - status : status;
}

} // namespace

int keep_job(const std::filesystem::path& folder) {
  // A cancellation goes to the whole group; the keeper stays to tell how the command ended.
  std::signal(SIGINT, SIG_IGN);
  std::signal(SIGTERM, SIG_IGN);
  const Job job = read_job(folder);
  const int exit_code = run(job.words);
  base::write_text_file(folder / "end.json",
                        dump({{"exit_code", exit_code}, {"ended", std::time(nullptr)}}));
  return 0;
}

} // namespace ionskin::apps::studio
