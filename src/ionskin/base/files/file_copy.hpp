// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/base/digest.hpp"
#include "ionskin/base/system/file_descriptor.hpp"

#include <cstdint>
#include <filesystem>

namespace ionskin::base {

/// The bytes of a file, copied into memory under no name: what is read from the copy is what the
/// digest stands for, whatever happens to the file meanwhile.
class FileCopy {
public:
  /// Throws UserError when the file cannot be read, is not a regular file (a folder, pipe or device
  /// is not waited for), is larger than half of the available memory or changes while it is copied.
  explicit FileCopy(const std::filesystem::path& path);

  /// Descriptor of the copy, at its beginning; closed on exec.
  int descriptor() const { return descriptor_; }
  std::uint64_t bytes() const { return bytes_; }
  const Digest& digest() const { return digest_; }

private:
  FileDescriptor descriptor_;
  std::uint64_t bytes_ = 0;
  Digest digest_;
};

/// The digest of a file's bytes. Throws UserError as FileCopy does, but for its size.
Digest file_digest(const std::filesystem::path& path);

} // namespace ionskin::base
