// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/base/digest.hpp"

#include <filesystem>
#include <optional>

namespace ionskin::base {

// A seal is a line behind the content of a file, with the build of the program that wrote it and
// the digest of all bytes before. HDF5 does not look behind its own end, and drops the seal of a
// file that it changes.

/// Puts the seal of this build behind a complete file. Throws UnwritableFile.
void seal(const std::filesystem::path& path);

/// State in which a sealed file was found.
enum class SealState {
  absent,      ///< there is no file
  damaged,     ///< changed, cut short, or never sealed
  other_build, ///< whole, but another build of the program wrote it
  whole
};
SealState check_seal(const std::filesystem::path& path);

/// Digest of a file's bytes; nothing when it cannot be read or is not a regular file. A link is not
/// followed.
std::optional<Digest> digest_if_readable(const std::filesystem::path& path);

} // namespace ionskin::base
