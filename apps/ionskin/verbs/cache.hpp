// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace ionskin::apps {

struct CacheOptions {
  std::string action; ///< "clear", or empty to show
};

/// Shows what older versions kept in the home folder of this user, or removes it.
int cache(const CacheOptions& options);

/// One line: where older versions kept files, how many are left, and what clears them.
std::string cache_summary();

} // namespace ionskin::apps
