// SPDX-License-Identifier: Apache-2.0
#include "verbs/cache.hpp"

#include "ionskin/base/byte_count.hpp"
#include "ionskin/base/files/disk_cache.hpp"

#include <fmt/core.h>

#include <cstdio>
#include <system_error>

namespace ionskin::apps {
namespace {

std::string size_text(std::uintmax_t bytes) {
  return base::byte_text(static_cast<double>(bytes));
}

} // namespace

std::string cache_summary() {
  const auto folder = base::cache_folder();
  const auto limit = base::cache_limit();
  if (!folder) {
    return "no cache: neither IONSKIN_CACHE nor HOME names a place";
  }
  const auto held = base::DiskCache(*folder, limit).content();
  return fmt::format("cache {}: {} entries, {}; {}", folder->string(), held.entries,
                     size_text(held.bytes),
                     limit > 0 ? "at most " + size_text(limit) + " (IONSKIN_CACHE_LIMIT)"
                               : "turned off by IONSKIN_CACHE_LIMIT");
}

int cache(const CacheOptions& options) {
  const auto folder = base::cache_folder();
  if (options.action == "clear" && folder) {
    const auto removed = base::DiskCache(*folder, base::cache_limit()).clear();
    fmt::print("{} entries removed, {}\n", removed.entries, size_text(removed.bytes));
  }
  fmt::print("{}\n", cache_summary());
  return 0;
}

void announce_cache(bool use_cache) {
  const auto folder = base::cache_folder();
  const auto limit = base::cache_limit();
  std::error_code error;
  if (use_cache && folder && limit > 0 && !std::filesystem::exists(*folder, error)) {
    std::fputs(fmt::format("note: mechanics are kept for later runs in {}, at most {}; ionskin "
                           "cache clear removes them, --no-cache keeps none (said once)\n",
                           folder->string(), size_text(limit))
                   .c_str(),
               stderr);
  }
}

} // namespace ionskin::apps
