// SPDX-License-Identifier: Apache-2.0
#include "ionskin/results/path_lock.hpp"

#include <cerrno>
#include <fcntl.h>
#include <sys/file.h>

namespace ionskin::results {

std::optional<base::FileDescriptor> lock_path(const std::filesystem::path& path, LockKind kind) {
  // Opening a pipe would wait for its writer.
  base::FileDescriptor descriptor(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
  const int operation = (kind == LockKind::exclusive ? LOCK_EX : LOCK_SH) | LOCK_NB;
  if (descriptor >= 0 && ::flock(descriptor, operation) != 0 && errno == EWOULDBLOCK) {
    return std::nullopt;
  }
  return descriptor;
}

} // namespace ionskin::results
