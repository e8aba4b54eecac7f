// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/base/system/file_descriptor.hpp"

#include <filesystem>
#include <optional>

namespace ionskin::results {

/// Kind of a lock: exclusive or shared.
enum class LockKind {
  exclusive,
  shared ///< beside others that are shared
};

/// A lock on a folder or a file, held while the object lives and at most as long as the process.
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

/// Locks a folder or a file. Nothing when another holds it. On file systems that know no such locks
/// there is none.
std::optional<PathLock> lock_path(const std::filesystem::path& path, LockKind kind);

} // namespace ionskin::results
