// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace ionskin::apps {

struct CacheOptions {
  std::string action; ///< "clear", or empty to show
};

/// Shows the cache of this user, or removes its entries.
int cache(const CacheOptions& options);

/// One line on the cache: where it is, what it holds and may hold.
std::string cache_summary();

/// Says on standard error that a cache is about to be made in the user's home, where none was yet.
void announce_cache(bool use_cache);

} // namespace ionskin::apps
