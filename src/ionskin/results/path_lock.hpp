// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/base/system/file_descriptor.hpp"

#include <filesystem>
#include <optional>

namespace ionskin::results {

/// Kind of a file lock.
enum class LockKind {
  exclusive, ///< refused while any other lock is held
  shared     ///< refused only while an exclusive lock is held
};

/// Lock on a folder or a file (flock). It is held while the object lives, and ends with the process
/// at the latest. A default-constructed object holds no lock.
class PathLock {
public:
  PathLock() = default;
  PathLock(PathLock&&) noexcept = default;
  PathLock& operator=(PathLock&&) noexcept = default;
  ~PathLock();

private:
  friend std::optional<PathLock> lock_path(const std::filesystem::path& path, LockKind kind);
  base::FileDescriptor file_;
};

/// Locks an existing folder or file without waiting. Returns nothing (`nullopt`) when another
/// process holds a conflicting lock. Where the path cannot be opened or the file system has no such
/// locks, the returned object holds no lock.
std::optional<PathLock> lock_path(const std::filesystem::path& path, LockKind kind);

} // namespace ionskin::results
