// SPDX-License-Identifier: Apache-2.0
#include "ionskin/results/path_lock.hpp"

#include <cerrno>
#include <fcntl.h>
#include <sys/file.h>

namespace ionskin::results {

// The lock is released explicitly. Closing the file is not enough: a child process that another
// thread is starting shares the open file until it executes its own program.
PathLock::~PathLock() {
  if (file_ >= 0) {
    ::flock(file_, LOCK_UN);
  }
}

std::optional<PathLock> lock_path(const std::filesystem::path& path, LockKind kind) {
  PathLock lock;
  // Without O_NONBLOCK, opening a pipe would wait for its writer.
  lock.file_ = base::FileDescriptor(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
  const int operation = (kind == LockKind::exclusive ? LOCK_EX : LOCK_SH) | LOCK_NB;
  if (lock.file_ >= 0 && ::flock(lock.file_, operation) != 0 && errno == EWOULDBLOCK) {
    return std::nullopt;
  }
  return lock;
}

} // namespace ionskin::results
