// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/base/digest.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace ionskin::base {

/// What stands in a cache.
struct CacheContent {
  std::size_t entries = 0;
  std::uintmax_t bytes = 0;
};

/// Results kept on disk under the digest of everything they depend on. It can only save time: a
/// missing, broken or foreign entry is computed anew, and what cannot be written is not kept.
///
/// One file an entry. Writers fill a temporary file, flush it to the disk and rename it, so readers
/// see whole files only, whoever writes at the same time or is killed. A checksum over the whole
/// content is verified at every read. When the files exceed the bound, the least recently used go.
/// Only regular files under the names of entries are read, counted or removed.
/// Safe to use from several threads and several processes.
class DiskCache {
public:
  /// @param most_bytes bound of all entries together
  DiskCache(std::filesystem::path folder, std::uintmax_t most_bytes);

  /// Whether there is an entry, whole or not.
  bool contains(const Digest& key) const;

  /// The content of an entry, or nothing. An unreadable or damaged entry is removed with a note.
  std::optional<std::vector<std::byte>> read(const Digest& key);

  /// Keeps the parts one behind the other, replacing the entry. Failures leave a note.
  void write(const Digest& key, const std::vector<std::span<const std::byte>>& parts);

  /// What went wrong since the last call, as sentences; each kind of failure once.
  std::vector<std::string> take_notes();

  CacheContent content() const;
  /// Removes every entry, what killed writers left, and the folder if nothing else is in it.
  /// @return what was removed
  CacheContent clear();

  const std::filesystem::path& folder() const { return folder_; }
  /// Bound of all entries together.
  std::uintmax_t most_bytes() const { return most_bytes_; }

private:
  std::filesystem::path file(const Digest& key) const;
  void make_room(std::uintmax_t bytes);
  void note(const std::string& text);

  std::filesystem::path folder_;
  std::uintmax_t most_bytes_;
  std::mutex mutex_;
  std::vector<std::string> notes_;
};

inline constexpr std::uintmax_t default_cache_limit = 5'000'000'000u; ///< [bytes]

/// The user's cache: the folder $IONSKIN_CACHE, or ionskin in $XDG_CACHE_HOME, or ~/.cache/ionskin;
/// at most $IONSKIN_CACHE_LIMIT, such as "500 MB" or "8 GB" (default 5 GB), 0 to turn it off.
/// Nothing when no folder is known. Throws UserError when the limit cannot be read.
std::optional<std::filesystem::path> cache_folder();
std::uintmax_t cache_limit();

} // namespace ionskin::base
