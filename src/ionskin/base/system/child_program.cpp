// SPDX-License-Identifier: Apache-2.0
#include "ionskin/base/system/child_program.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/base/system/interrupt.hpp"
#include "ionskin/base/system/processes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <map>
#include <mutex>
#include <poll.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/wait.h>

namespace ionskin::base {
namespace {

/// Descriptors of the child.
constexpr int child_input = 0, child_file = 3, child_image = 4;
/// Lowest descriptor of this process to pass on: above those of the child, so that none is
/// overwritten while they are duplicated.
constexpr int lowest_own = 10;
/// Interval between checks for a request to stop [ms].
constexpr int patience = 200;
/// Time limit for a child that has closed its end to exit, before it is killed [ms].
constexpr int farewell = 1000;

[[noreturn]] void refuse(const std::string& name, int error) {
  throw UserError(fmt::format("{} cannot be started: {}\n  = free memory or end other programs of "
                              "yours (ulimit -a shows the limits)",
                              name, std::strerror(error)));
}

FileDescriptor above_own(int descriptor, const std::string& name) {
  FileDescriptor moved(fcntl(descriptor, F_DUPFD_CLOEXEC, lowest_own));
  if (moved < 0) {
    refuse(name, errno);
  }
  return moved;
}

/// Descriptor of a file in memory with the executable; created once per image.
int image_file(std::string_view image, const std::string& name) {
  static std::mutex mutex;
  static std::map<const char*, FileDescriptor> files;
  const std::lock_guard lock(mutex);
  if (const auto known = files.find(image.data()); known != files.end()) {
    return known->second;
  }
  const FileDescriptor made(memfd_create(name.c_str(), MFD_CLOEXEC));
  if (made < 0) {
    refuse(name, errno);
  }
  FileDescriptor file = above_own(made, name);
  for (std::string_view rest = image; !rest.empty();) {
    const ssize_t written = write(file, rest.data(), rest.size());
    if (written < 0 && errno != EINTR) {
      refuse(name, errno);
    }
    rest.remove_prefix(static_cast<std::size_t>(std::max<ssize_t>(written, 0)));
  }
  return files.emplace(image.data(), std::move(file)).first->second;
}

/// Settings of posix_spawn for the new process.
class SpawnSettings {
public:
  SpawnSettings() {
    posix_spawn_file_actions_init(&actions);
    posix_spawnattr_init(&attributes);
  }
  ~SpawnSettings() {
    posix_spawn_file_actions_destroy(&actions);
    posix_spawnattr_destroy(&attributes);
  }
  SpawnSettings(const SpawnSettings&) = delete;
  SpawnSettings& operator=(const SpawnSettings&) = delete;

  posix_spawn_file_actions_t actions;
  posix_spawnattr_t attributes;
};

void give_descriptors(SpawnSettings& settings, int socket, int file, int image) {
  posix_spawn_file_actions_adddup2(&settings.actions, socket, child_input);
  posix_spawn_file_actions_addopen(&settings.actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_adddup2(&settings.actions, STDOUT_FILENO, STDERR_FILENO);
  posix_spawn_file_actions_adddup2(&settings.actions, file, child_file);
  posix_spawn_file_actions_adddup2(&settings.actions, image, child_image);
  posix_spawn_file_actions_addclosefrom_np(&settings.actions, child_image + 1);
}

/// Puts the child into a process group of its own, which Ctrl-C at the terminal does not reach,
/// with default signal handlers and no blocked signals.
void give_signals(SpawnSettings& settings) {
  sigset_t none, all;
  sigemptyset(&none);
  sigfillset(&all);
  posix_spawnattr_setsigmask(&settings.attributes, &none);
  posix_spawnattr_setsigdefault(&settings.attributes, &all);
  posix_spawnattr_setpgroup(&settings.attributes, 0);
  posix_spawnattr_setflags(&settings.attributes,
                           POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
}

} // namespace

ChildProgram::ChildProgram(std::string_view image, const std::string& name,
                           const std::vector<std::string>& arguments, int file) {
  int ends[2];
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) {
    refuse(name, errno);
  }
  socket_ = FileDescriptor(ends[0]);
  const FileDescriptor theirs(ends[1]);
  const FileDescriptor moved_socket = above_own(theirs, name), moved_file = above_own(file, name);
  SpawnSettings settings;
  give_descriptors(settings, moved_socket, moved_file, image_file(image, name));
  give_signals(settings);
  std::vector<std::string> texts{name};
  texts.insert(texts.end(), arguments.begin(), arguments.end());
  // A wheel sets IONSKIN_LIBRARIES to the folder of its libraries, because an image in memory has
  // no folder relative to which they could be found.
  const char* beside = std::getenv("IONSKIN_LIBRARIES");
  const char* libraries = beside != nullptr ? beside : std::getenv("LD_LIBRARY_PATH");
  std::string search = fmt::format("LD_LIBRARY_PATH={}", libraries == nullptr ? "" : libraries);
  char* environment[] = {libraries == nullptr ? nullptr : search.data(), nullptr};
  const std::string path = fmt::format("/proc/self/fd/{}", child_image);
  const int error = posix_spawn(&process_, path.c_str(), &settings.actions, &settings.attributes,
                                argument_pointers(texts).data(), environment);
  if (error != 0) {
    process_ = -1;
    refuse(name, error);
  }
}

ChildProgram::~ChildProgram() {
  end();
}

ChildProgram::Transfer ChildProgram::send(const void* bytes, std::size_t count) {
  const char* next = static_cast<const char*>(bytes);
  while (count > 0) {
    const ssize_t sent = ::send(socket_, next, count, MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR) {
      continue;
    }
    if (sent < 0) {
      return Transfer::ended;
    }
    next += sent;
    count -= static_cast<std::size_t>(sent);
  }
  return Transfer::done;
}

ChildProgram::Transfer ChildProgram::receive(void* bytes, std::size_t count, double seconds) {
  using Clock = std::chrono::steady_clock;
  const auto deadline = Clock::now() + std::chrono::duration<double>(seconds);
  char* next = static_cast<char*>(bytes);
  while (count > 0) {
    check_interrupt();
    if (Clock::now() > deadline) {
      return Transfer::late;
    }
    pollfd waiting{socket_, POLLIN, 0};
    if (poll(&waiting, 1, patience) <= 0) {
      continue;
    }
    const ssize_t got = recv(socket_, next, count, 0);
    if (got < 0 && errno == EINTR) {
      continue;
    }
    if (got <= 0) {
      return Transfer::ended;
    }
    next += got;
    count -= static_cast<std::size_t>(got);
  }
  return Transfer::done;
}

int ChildProgram::end() {
  if (process_ < 0) {
    return 0;
  }
  int status = 0;
  pid_t ended = 0;
  // If the child has closed its end, waits for it to exit, so that a crash shows as its signal.
  pollfd closed{socket_, POLLIN, 0};
  const bool gone = poll(&closed, 1, 0) > 0;
  for (int waited = 0; gone && waited < farewell && ended == 0; ++waited) {
    ended = waitpid(process_, &status, WNOHANG);
    if (ended == 0) {
      poll(nullptr, 0, 1);
    }
  }
  if (ended == 0) {
    kill(process_, SIGKILL);
    do {
      ended = waitpid(process_, &status, 0);
    } while (ended < 0 && errno == EINTR);
    status = 0;
  }
  process_ = -1;
  return ended > 0 && WIFSIGNALED(status) ? WTERMSIG(status) : 0;
}

} // namespace ionskin::base
