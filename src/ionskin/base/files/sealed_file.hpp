// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/base/digest.hpp"

#include <filesystem>
#include <optional>

namespace ionskin::base {

// A seal is a line at the end of a file, with the build of the program that wrote the file and the
// digest of all bytes before. It shows whether the file is complete and unchanged. HDF5 ignores
// bytes behind its own end, and drops the seal of a file that it changes.

/// Appends the seal of this build to a complete file. Throws UnwritableFile when the file cannot be
/// read or written.
void seal(const std::filesystem::path& path);

/// Result of checking the seal of a file.
enum class SealState {
  absent,      ///< there is no file
  damaged,     ///< changed, truncated, or never sealed
  other_build, ///< unchanged, but written by another build of the program
  whole        ///< unchanged since this build of the program wrote it
};
/// Reads a file and checks its seal. Links are not followed: a link counts as damaged.
SealState check_seal(const std::filesystem::path& path);

/// Digest of the bytes of a regular file, for comparison with other digests of this function only:
/// it differs from `file_digest`. Nothing (`nullopt`) when the file cannot be read, is not a
/// regular file, or is a link.
std::optional<Digest> digest_if_readable(const std::filesystem::path& path);

} // namespace ionskin::base
