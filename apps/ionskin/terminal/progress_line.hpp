// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>

namespace ionskin::apps {

/// Progress of an activity.
struct ProgressState {
  std::string activity;
  double fraction = 0; ///< finished, in [0, 1]
  double elapsed = 0;  ///< [s]

  bool time_left_known() const;
  double time_left() const; ///< if it goes on as so far [s]
};

/// The state in one line that fits into `columns`: name, bar, percentage and time. Where there is
/// no room the bar is left out first, then the time; a long name is cut.
std::string bar_line(const ProgressState& state, std::size_t columns);

/// The same as a sentence of a log.
std::string log_line(const ProgressState& state);

/// The same as one JSON object; `time_left_s` is null while it is not known.
std::string json_line(const ProgressState& state);

} // namespace ionskin::apps
