// SPDX-License-Identifier: Apache-2.0
#include "verbs/cache.hpp"

#include "ionskin/base/byte_count.hpp"
#include "ionskin/base/files/atomic_file.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <system_error>
#include <utility>
#include <vector>

namespace ionskin::apps {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view entry_suffix = ".ionskin-cache";

/// Cache folder of older versions; nullopt where the environment names none.
std::optional<fs::path> cache_folder() {
  constexpr std::array<std::pair<const char*, const char*>, 3> places{
      {{"IONSKIN_CACHE", ""}, {"XDG_CACHE_HOME", "ionskin"}, {"HOME", ".cache/ionskin"}}};
  for (const auto& [variable, below] : places) {
    if (const char* value = std::getenv(variable); value != nullptr && *value != '\0') {
      return *below == '\0' ? fs::path(value) : fs::path(value) / below;
    }
  }
  return std::nullopt;
}

/// True if a file name is one that older versions gave: a key followed by the suffix of a cache
/// entry, or by that of an entry whose writer was killed.
bool is_own_name(const std::string& name) {
  constexpr std::size_t digits = 32;
  const bool entry = name.ends_with(entry_suffix);
  return name.find_first_not_of("0123456789abcdef") == digits &&
         (entry ? name.size() == digits + entry_suffix.size()
                : name.ends_with(base::pending_suffix));
}

/// Files that older versions left in the folder: regular files with names of theirs, whatever else
/// the user keeps there.
struct Left {
  std::vector<fs::path> files;
  std::uintmax_t bytes = 0;

  std::string text() const {
    return fmt::format("{} {}, {}", files.size(), files.size() == 1 ? "file" : "files",
                       base::byte_text(static_cast<double>(bytes)));
  }
};

Left left_in(const fs::path& folder) {
  Left left;
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    std::error_code gone;
    const bool regular = fs::is_regular_file(at->symlink_status(gone));
    const std::uintmax_t size = regular ? at->file_size(gone) : 0;
    if (regular && !gone && is_own_name(at->path().filename().string())) {
      left.files.push_back(at->path());
      left.bytes += size;
    }
  }
  return left;
}

/// Removes the files of older versions, and the folder when it is empty then.
/// @return the removed files
Left remove_from(const fs::path& folder) {
  Left removed;
  for (const fs::path& file : left_in(folder).files) {
    std::error_code error;
    const std::uintmax_t size = fs::file_size(file, error);
    if (!error && fs::remove(file, error)) {
      removed.files.push_back(file);
      removed.bytes += size;
    }
  }
  std::error_code ignored; // only an empty folder goes
  if (!fs::is_symlink(fs::symlink_status(folder, ignored))) {
    fs::remove(folder, ignored);
  }
  return removed;
}

} // namespace

std::string cache_summary() {
  const auto folder = cache_folder();
  if (!folder) {
    return "no files of older versions: neither IONSKIN_CACHE nor HOME names a place";
  }
  const Left left = left_in(*folder);
  return left.files.empty()
             ? fmt::format("no files of older versions in {}; this one keeps none",
                           folder->string())
             : fmt::format("older versions left {} in {}; ionskin cache clear removes them",
                           left.text(), folder->string());
}

int cache(const CacheOptions& options) {
  const auto folder = cache_folder();
  if (options.action == "clear" && folder) {
    fmt::print("{} removed\n", remove_from(*folder).text());
  }
  fmt::print("{}\n", cache_summary());
  return 0;
}

} // namespace ionskin::apps
