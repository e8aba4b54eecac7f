// SPDX-License-Identifier: Apache-2.0
#include "studio/jobs/job_keeper.hpp"

#include "ionskin/base/files/atomic_file.hpp"
#include "studio/jobs/job.hpp"

#include <cerrno>
#include <csignal>
#include <ctime>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace ionskin::apps::studio {
namespace {

/// Starts the command in this process group, with the signals that the keeper ignores.
int run(const std::vector<std::string>& words) {
  std::vector<std::string> all{program().string()};
  all.insert(all.end(), words.begin(), words.end());
  std::vector<char*> pointers;
  for (std::string& word : all) {
    pointers.push_back(word.data());
  }
  pointers.push_back(nullptr);
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGINT);
  sigaddset(&signals, SIGTERM);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setsigdefault(&attributes, &signals);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGDEF);
  pid_t child = 0;
  const int problem =
      posix_spawn(&child, all[0].c_str(), nullptr, &attributes, pointers.data(), environ);
  posix_spawnattr_destroy(&attributes);
  if (problem != 0) {
    return 127;
  }
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
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
