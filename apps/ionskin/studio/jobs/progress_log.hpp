// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/server/json.hpp"

#include <string>

namespace ionskin::apps::studio {

/// What a command said on its standard error with `--log json`: how far it is, and its messages.
struct ProgressLog {
  std::string activity;
  double fraction = 0;  ///< of the activity
  double left = -1;     ///< of the activity [s]; negative when not known
  std::string messages; ///< lines that tell no progress
};

/// @param text the end of what was said; a first line that is cut is passed over
ProgressLog read_progress(const std::string& text);

} // namespace ionskin::apps::studio
