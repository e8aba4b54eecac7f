// SPDX-License-Identifier: Apache-2.0
#include "studio/jobs/process.hpp"

#include "ionskin/base/system/processes.hpp"
#include "studio/jobs/confinement.hpp"
#include "studio/server/limits.hpp"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <fstream>
#include <iterator>
#include <poll.h>
#include <sstream>
#include <sys/resource.h>
#include <system_error>
#include <unistd.h>

namespace ionskin::apps::studio {
namespace {

std::string content(const char* path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// Start time of a process, in ticks since boot, as text; empty when the process has ended.
std::string start_ticks(pid_t pid) {
  const std::string stat = content(("/proc/" + std::to_string(pid) + "/stat").c_str());
  const std::size_t name_end = stat.rfind(')'); // names may hold blanks and parentheses
  if (name_end == std::string::npos) {
    return "";
  }
  std::istringstream fields(stat.substr(name_end + 1));
  const std::vector<std::string> words{std::istream_iterator<std::string>(fields), {}};
  constexpr std::size_t state = 0, start = 19; // counted from the state, the third field of proc(5)
  return words.size() > start && words[state] != "Z" ? words[start] : "";
}

/// Turns the forked child into the program. Uses only calls that are safe between fork and exec.
[[noreturn]] void become(char* const* words, int folder, int input, int output, int errors,
                         std::size_t memory, const Confinement* confinement) {
  setsid();
  struct sigaction standard {};
  standard.sa_handler = SIG_DFL;
  for (const int signal : {SIGCHLD, SIGINT, SIGTERM, SIGPIPE, SIGHUP}) {
    sigaction(signal, &standard, nullptr);
  }
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  if (memory > 0) {
    const rlimit bound{memory, memory};
    setrlimit(RLIMIT_AS, &bound);
  }
  if (fchdir(folder) == 0 && dup2(input, STDIN_FILENO) >= 0 && dup2(output, STDOUT_FILENO) >= 0 &&
      dup2(errors, STDERR_FILENO) >= 0 && (confinement == nullptr || confinement->enter())) {
    close_range(STDERR_FILENO + 1, ~0u, 0);
    execv(words[0], words);
  }
  _exit(127);
}

pid_t start(const std::vector<std::string>& words, int folder, int output, int errors,
            std::size_t memory, const Confinement* confinement) {
  std::vector<std::string> copies = words;
  const std::vector<char*> pointers = base::argument_pointers(copies);
  const int input = ::open("/dev/null", O_RDONLY | O_CLOEXEC);
  const pid_t child = fork();
  if (child == 0) {
    become(pointers.data(), folder, input, output, errors, memory, confinement);
  }
  const int reason = errno;
  ::close(input);
  if (child < 0) {
    throw std::system_error(reason, std::generic_category(), "a program cannot be started");
  }
  return child;
}

int open_to_write(const std::filesystem::path& path) {
  const int file =
      ::open(path.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC | O_NOFOLLOW, 0644);
  if (file < 0) {
    throw std::system_error(errno, std::generic_category(), path.string());
  }
  return file;
}

/// Reads available data from a pipe and appends them to `text`, up to `limits::child_output`.
/// Returns false at the end of the pipe.
bool take(int file, std::string& text) {
  std::array<char, 65536> buffer{};
  const ssize_t count = ::read(file, buffer.data(), buffer.size());
  if (count > 0 && text.size() < limits::child_output) {
    text.append(buffer.data(), static_cast<std::size_t>(count));
  }
  return count > 0 || (count < 0 && errno == EINTR);
}

/// Reads the output pipes of a program until they close or the time is over. Returns true when they
/// closed.
bool drain(std::array<pollfd, 2> ends, Outcome& outcome,
           std::chrono::steady_clock::time_point end) {
  std::array<std::string*, 2> texts{&outcome.output, &outcome.errors};
  while (ends[0].fd >= 0 || ends[1].fd >= 0) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(
        end - std::chrono::steady_clock::now());
    if (left.count() <= 0) {
      return false;
    }
    if (::poll(ends.data(), ends.size(), static_cast<int>(left.count())) <= 0) {
      continue;
    }
    for (std::size_t i = 0; i < ends.size(); ++i) {
      if (ends[i].fd >= 0 && ends[i].revents != 0 && !take(ends[i].fd, *texts[i])) {
        ends[i].fd = -1;
      }
    }
  }
  return true;
}

} // namespace

void Outcome::rename(const std::string& given, const std::string& known) {
  for (std::size_t at = errors.find(given); at != std::string::npos;
       at = errors.find(given, at + known.size())) {
    errors.replace(at, given.size(), known);
  }
}

bool ProcessId::alive() const {
  return pid > 0 && !started.empty() && identify(pid).started == started;
}

ProcessId identify(pid_t pid) {
  const std::string ticks = start_ticks(pid);
  if (ticks.empty()) {
    return {pid, ""};
  }
  std::string boot = content("/proc/sys/kernel/random/boot_id");
  boot = boot.substr(0, boot.find('\n'));
  return {pid, ticks + " " + boot};
}

std::filesystem::path program() {
  const char* front = std::getenv("IONSKIN_FRONT");
  return front != nullptr ? std::filesystem::path(front)
                          : std::filesystem::canonical("/proc/self/exe").parent_path() / "ionskin";
}

pid_t start_detached(const std::vector<std::string>& words, const base::FileDescriptor& folder,
                     const std::filesystem::path& output, const std::filesystem::path& errors) {
  const int out = open_to_write(output);
  const int err = open_to_write(errors);
  const pid_t child = start(words, folder, out, err, 0, nullptr);
  ::close(out);
  ::close(err);
  return child;
}

Outcome run_to_end(const std::vector<std::string>& words, const base::FileDescriptor& folder,
                   std::chrono::seconds time, std::size_t memory) {
  const Confinement confinement(folder);
  int out[2], err[2];
  if (pipe2(out, O_CLOEXEC) != 0) {
    throw std::system_error(errno, std::generic_category(), "pipe");
  }
  if (pipe2(err, O_CLOEXEC) != 0) {
    ::close(out[0]);
    ::close(out[1]);
    throw std::system_error(errno, std::generic_category(), "pipe");
  }
  const pid_t child = start(words, folder, out[1], err[1], memory, &confinement);
  ::close(out[1]);
  ::close(err[1]);
  Outcome outcome;
  const auto end = std::chrono::steady_clock::now() + time;
  outcome.timed_out = !drain({pollfd{out[0], POLLIN, 0}, pollfd{err[0], POLLIN, 0}}, outcome, end);
  if (outcome.timed_out) {
    kill(-child, SIGKILL); // its whole session
  }
  ::close(out[0]);
  ::close(err[0]);
  outcome.exit_code = base::wait_for_end(child);
  return outcome;
}

} // namespace ionskin::apps::studio
