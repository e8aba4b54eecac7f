// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

namespace ionskin::apps::studio {

/// Progress and messages of a command, read from its standard error, which it writes with `--log
/// json`.
struct ProgressLog {
  std::string activity; ///< name of the present activity; empty before the first
  double fraction = 0;  ///< finished part of the activity, in [0, 1]
  double left = -1;     ///< estimated remaining time of the activity [s]; negative when not known
  std::string messages; ///< lines that are not progress, such as warnings and errors
};

/// Reads the progress from the last `limits::log_tail` bytes of a file; a first line that is cut is
/// ignored. Empty for a file that does not exist.
/// @param messages file of the command's standard error
ProgressLog read_progress(const std::filesystem::path& messages);

} // namespace ionskin::apps::studio
