// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace ionskin::apps {

/// Options of `ionskin cache`.
struct CacheOptions {
  std::string action; ///< "clear" to remove files of older versions, empty to show them
};

/// Runs `ionskin cache`: shows the files that older versions of ionskin left in the home folder of
/// this user, or removes them. Returns the exit code 0.
int cache(const CacheOptions& options);

/// Line of text that says how many files older versions left, in which folder, and which command
/// removes them.
std::string cache_summary();

} // namespace ionskin::apps
