// SPDX-License-Identifier: Apache-2.0
#include "ionskin/base/files/disk_cache.hpp"

#include "ionskin/base/byte_count.hpp"
#include "ionskin/base/error.hpp"
#include "ionskin/base/files/atomic_file.hpp"
#include "ionskin/base/files/cache_file.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <sstream>
#include <system_error>
#include <utility>

namespace ionskin::base {
namespace {

namespace fs = std::filesystem;

constexpr const char* entry_suffix = ".ionskin-cache";
/// Temporary files older than this belong to writers that were killed.
constexpr std::chrono::hours pending_age{1};

struct Entry {
  fs::path path;
  std::uintmax_t bytes = 0;
  fs::file_time_type used;
};

/// Whether a name begins with a key and ends with a suffix; that of an entry holds nothing else.
bool is_own_name(const std::string& name, const std::string& suffix) {
  constexpr std::size_t digits = 32;
  return name.find_first_not_of("0123456789abcdef") == digits && name.ends_with(suffix) &&
         (suffix != entry_suffix || name.size() == digits + suffix.size());
}

/// The entries of a folder, or those that are being written: regular files under names of ours,
/// whatever else the user keeps there. What other processes remove meanwhile is left out.
std::vector<Entry> entries(const fs::path& folder, const char* suffix) {
  std::vector<Entry> result;
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    std::error_code gone;
    if (!is_own_name(at->path().filename().string(), suffix) ||
        !fs::is_regular_file(at->symlink_status(gone))) {
      continue;
    }
    Entry entry{at->path(), at->file_size(gone), {}};
    entry.used = gone ? fs::file_time_type{} : at->last_write_time(gone);
    if (!gone) {
      result.push_back(std::move(entry));
    }
  }
  return result;
}

void remove_quietly(const fs::path& path) {
  std::error_code ignored;
  fs::remove(path, ignored);
}

} // namespace

DiskCache::DiskCache(fs::path folder, std::uintmax_t most_bytes)
    : folder_(std::move(folder)), most_bytes_(most_bytes) {}

fs::path DiskCache::file(const Digest& key) const {
  return folder_ / (key.hex() + entry_suffix);
}

void DiskCache::note(const std::string& text) {
  const std::lock_guard lock(mutex_);
  if (std::find(notes_.begin(), notes_.end(), text) == notes_.end()) {
    notes_.push_back(text);
  }
}

std::vector<std::string> DiskCache::take_notes() {
  const std::lock_guard lock(mutex_);
  return std::exchange(notes_, {});
}

bool DiskCache::contains(const Digest& key) const {
  std::error_code unreadable;
  return fs::is_regular_file(fs::symlink_status(file(key), unreadable));
}

std::optional<std::vector<std::byte>> DiskCache::read(const Digest& key) {
  const fs::path path = file(key);
  CacheFileContent found = read_cache_file(path, key);
  if (found.state == CacheFileState::whole) {
    // The time of the last change serves as the time of the last use.
    std::error_code ignored;
    fs::last_write_time(path, fs::file_time_type::clock::now(), ignored);
    return std::move(found.content);
  }
  if (found.state == CacheFileState::damaged) {
    note(fmt::format("A damaged or foreign file in the cache {} was ignored and is replaced.",
                     folder_.string()));
    remove_quietly(path);
  }
  return std::nullopt;
}

void DiskCache::make_room(std::uintmax_t bytes) {
  const auto now = fs::file_time_type::clock::now();
  for (const Entry& pending : entries(folder_, pending_suffix)) {
    if (now - pending.used > pending_age) {
      remove_quietly(pending.path);
    }
  }
  std::vector<Entry> kept = entries(folder_, entry_suffix);
  std::sort(kept.begin(), kept.end(),
            [](const Entry& a, const Entry& b) { return a.used < b.used; });
  std::uintmax_t total = bytes;
  for (const Entry& entry : kept) {
    total += entry.bytes;
  }
  for (const Entry& entry : kept) {
    if (total <= most_bytes_) {
      return;
    }
    remove_quietly(entry.path);
    total -= entry.bytes;
  }
}

void DiskCache::write(const Digest& key, const std::vector<std::span<const std::byte>>& parts) {
  std::uintmax_t bytes = 0;
  for (const auto& part : parts) {
    bytes += part.size();
  }
  if (bytes > most_bytes_) {
    note(fmt::format("A result of {:.2g} GB exceeds the bound of the cache ({:.2g} GB) and was not "
                     "kept: raise IONSKIN_CACHE_LIMIT to keep it.",
                     static_cast<double>(bytes) * 1e-9, static_cast<double>(most_bytes_) * 1e-9));
    return;
  }
  std::error_code error;
  fs::create_directories(folder_, error);
  std::string failure = error ? error.message() : "";
  if (failure.empty()) {
    make_room(bytes);
    failure = write_cache_file(file(key), key, parts);
  }
  if (!failure.empty()) {
    note(
        fmt::format("Nothing was kept in the cache {}: {}. Results do not depend on it; --no-cache "
                    "or another IONSKIN_CACHE avoids this warning.",
                    folder_.string(), failure));
  }
}

CacheContent DiskCache::content() const {
  CacheContent result;
  for (const Entry& entry : entries(folder_, entry_suffix)) {
    ++result.entries;
    result.bytes += entry.bytes;
  }
  return result;
}

CacheContent DiskCache::clear() {
  CacheContent removed;
  for (const char* suffix : {entry_suffix, pending_suffix}) {
    for (const Entry& entry : entries(folder_, suffix)) {
      std::error_code error;
      if (fs::remove(entry.path, error)) {
        ++removed.entries;
        removed.bytes += entry.bytes;
      }
    }
  }
  std::error_code ignored; // only an empty folder goes
  if (!fs::is_symlink(fs::symlink_status(folder_, ignored))) {
    fs::remove(folder_, ignored);
  }
  return removed;
}

std::optional<fs::path> cache_folder() {
  const auto set = [](const char* name) -> const char* {
    const char* value = std::getenv(name);
    return value != nullptr && *value != '\0' ? value : nullptr;
  };
  if (const char* own = set("IONSKIN_CACHE")) {
    return fs::path(own);
  }
  if (const char* shared = set("XDG_CACHE_HOME")) {
    return fs::path(shared) / "ionskin";
  }
  if (const char* home = set("HOME")) {
    return fs::path(home) / ".cache" / "ionskin";
  }
  return std::nullopt;
}

std::uintmax_t cache_limit() {
  const char* text = std::getenv("IONSKIN_CACHE_LIMIT");
  if (text == nullptr || *text == '\0') {
    return default_cache_limit;
  }
  return byte_count("IONSKIN_CACHE_LIMIT", text);
}

} // namespace ionskin::base
