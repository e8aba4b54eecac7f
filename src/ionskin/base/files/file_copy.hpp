// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/base/digest.hpp"
#include "ionskin/base/system/file_descriptor.hpp"

#include <cstdint>
#include <filesystem>

namespace ionskin::base {

/// Copy of a file in memory, without a name, and its digest. The copy stays as the digest says,
/// whatever happens to the file in the meantime.
class FileCopy {
public:
  /// Copies a file. Throws UserError when the file cannot be read, is not a regular file (it does
  /// not wait for a pipe or device), is larger than half of the available memory, or changes while
  /// it is copied.
  explicit FileCopy(const std::filesystem::path& path);

  /// File descriptor of the copy, positioned at its beginning; closed on exec and with this object.
  int descriptor() const { return descriptor_; }
  std::uint64_t bytes() const { return bytes_; }
  const Digest& digest() const { return digest_; }

private:
  FileDescriptor descriptor_;
  std::uint64_t bytes_ = 0;
  Digest digest_;
};

/// Computes the digest of the bytes of a regular file of any size, equal to `FileCopy::digest`.
/// Throws UserError when the file cannot be read, is not a regular file, or changes while it is
/// read.
Digest file_digest(const std::filesystem::path& path);

} // namespace ionskin::base
