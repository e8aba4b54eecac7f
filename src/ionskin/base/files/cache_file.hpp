// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/base/digest.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace ionskin::base {

/// Version of the layout of cache files; another one is a foreign file.
inline constexpr std::uint32_t cache_file_version = 1;

/// How a cache file was found.
enum class CacheFileState { absent, damaged, whole };

/// A cache file as read; the content is empty unless it is whole.
struct CacheFileContent {
  CacheFileState state = CacheFileState::absent;
  std::vector<std::byte> content;
};

/// Reads a file and verifies its mark, version, key, length and checksum.
CacheFileContent read_cache_file(const std::filesystem::path& path, const Digest& key);

/// Writes a file, see PendingFile.
/// @return what went wrong, empty on success; then nothing is left behind
std::string write_cache_file(const std::filesystem::path& path, const Digest& key,
                             const std::vector<std::span<const std::byte>>& parts);

} // namespace ionskin::base
