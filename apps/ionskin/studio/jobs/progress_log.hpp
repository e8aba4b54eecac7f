// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

namespace ionskin::apps::studio {

/// Log of a command, from its standard error with `--log json`: how far it is, and its messages.
struct ProgressLog {
  std::string activity;
  double fraction = 0;  ///< of the activity
  double left = -1;     ///< of the activity [s]; negative when not known
  std::string messages; ///< lines that tell no progress
};

/// Log from the last `limits::log_tail` bytes of a file; a first line that is cut is passed over.
/// Nothing of a file that is not there.
ProgressLog read_progress(const std::filesystem::path& messages);

} // namespace ionskin::apps::studio
