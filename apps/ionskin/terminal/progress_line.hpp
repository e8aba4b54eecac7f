// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>

namespace ionskin::apps {

/// Progress of one activity of a command, as a line of the display shows it.
struct ProgressState {
  std::string activity; ///< name of the activity
  double fraction = 0;  ///< finished part, in [0, 1]
  double elapsed = 0;   ///< time since the activity began [s]

  bool time_left_known() const; ///< true if more than 2 % are finished
  double time_left() const;     ///< estimate of the remaining time at the average speed so far [s]
};

/// Text of a progress bar in one line of at most `columns` characters: name, bar, percentage and
/// time. Where there is no room the bar is left out first, then the time; a long name is cut.
std::string bar_line(const ProgressState& state, std::size_t columns);

/// Text of the progress as one line of a log: name, percentage, elapsed and remaining time.
std::string log_line(const ProgressState& state);

/// Progress as one line of JSON, an object with `activity`, `fraction`, `elapsed_s` and
/// `time_left_s`; `time_left_s` is null while it is not known.
std::string json_line(const ProgressState& state);

} // namespace ionskin::apps
