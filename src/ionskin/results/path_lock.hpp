// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/base/system/file_descriptor.hpp"

#include <filesystem>
#include <optional>

namespace ionskin::results {

/// Whether a lock is shared.
enum class LockKind {
  exclusive,
  shared ///< beside others that are shared
};

/// Locks a folder or a file while the result lives, at most as long as the process. Nothing when
/// another holds it. On file systems that know no such locks there is none.
std::optional<base::FileDescriptor> lock_path(const std::filesystem::path& path, LockKind kind);

} // namespace ionskin::results
