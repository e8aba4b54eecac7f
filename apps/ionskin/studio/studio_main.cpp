// SPDX-License-Identifier: Apache-2.0

// The Studio: a server for one user and one folder, and the keeper of each of its jobs. `ionskin
// studio` becomes this program.

#include "command_line/command_line.hpp"
#include "command_line/guard.hpp"
#include "studio/jobs/confinement.hpp"
#include "studio/jobs/job_keeper.hpp"
#include "studio/server/server.hpp"

#include <fmt/core.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <string_view>
#include <thread>

namespace ionskin::apps {
namespace {

/// Opens the browser on the link file, never on the link itself, since every user can see command
/// lines.
void open_browser(studio::Server& server, const base::FileDescriptor& folder) {
  const char* const browser = std::getenv("BROWSER");
  const bool chosen = browser != nullptr && browser[0] == '/';
  try {
    studio::start_detached({chosen ? browser : "/usr/bin/xdg-open", server.link_file().string()},
                           folder, "/dev/null", "/dev/null");
  } catch (const std::exception&) {
    return; // the link is printed
  }
}

/// Serves the workspace until Ctrl-C or SIGTERM; jobs continue. Returns the exit code.
int serve(const StudioOptions& options) {
  sigset_t ends;
  sigemptyset(&ends);
  sigaddset(&ends, SIGINT);
  sigaddset(&ends, SIGTERM);
  pthread_sigmask(SIG_BLOCK, &ends, nullptr);
  std::signal(SIGPIPE, SIG_IGN);
  studio::Workspace workspace(options.folder);
  if (!studio::Confinement::is_available()) {
    fmt::print(stderr, "warning: this kernel has no Landlock: a link that others put into the "
                       "workspace while a command runs may lead it outside\n");
  }
  studio::JobQueue jobs(workspace);
  studio::Server server(workspace, jobs, options.port);
  fmt::print("ionskin studio: {}\n", server.link());
  std::fflush(stdout);
  if (!options.no_browser) {
    open_browser(server, workspace.folder());
  }
  std::thread waiter([&] {
    int signal = 0;
    sigwait(&ends, &signal);
    server.stop();
  });
  server.listen();
  waiter.join();
  return 0;
}

} // namespace
} // namespace ionskin::apps

int main(int argc, char** argv) {
  using namespace ionskin::apps;
  return guarded([&]() -> int {
    if (argc == 3 && std::string_view(argv[1]) == "--keep") {
      return studio::keep_job(argv[2]);
    }
    int exit_code = 0;
    const auto command = parse_command_line(argc, argv, exit_code);
    if (!command) {
      return exit_code;
    }
    return serve(std::get<StudioOptions>(*command));
  });
}
