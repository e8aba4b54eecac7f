// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "command_line/options.hpp"
#include "ionskin/base/progress.hpp"
#include "terminal/progress_line.hpp"

#include <condition_variable>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>

namespace ionskin::apps {

/// Display of a command's progress on stderr, in one of the forms of `LogFormat`: a bar as wide as
/// the terminal, lines of a log, JSON lines, or nothing. The fraction of an activity never goes
/// back. While the work reports nothing, bar and lines still update the time. Every function may be
/// called from several threads at once.
class ProgressDisplay {
public:
  explicit ProgressDisplay(LogFormat format);
  ~ProgressDisplay();
  ProgressDisplay(const ProgressDisplay&) = delete;
  ProgressDisplay& operator=(const ProgressDisplay&) = delete;

  /// Shows the progress of an activity; another name begins a new activity.
  /// @param fraction finished part of the activity in [0, 1]. A smaller fraction than before is
  /// ignored, except after 1, where it begins the activity anew.
  void update(std::string_view activity, double fraction);
  /// Prints a message for the user on a line of its own, in the forms bar and lines only.
  void tell(const std::string& text);
  /// Callback that calls `update` of this display, which must outlive the callback.
  base::ProgressCallback callback();

private:
  void begin(std::string_view activity);
  void show(bool forced);
  void show_bar(bool forced);
  void show_line(bool forced);
  void show_json(bool forced);
  void end_bar();
  void tick(const std::stop_token& stop);

  std::mutex mutex_;
  LogFormat format_;
  ProgressState state_;
  double start_ = 0; ///< begin of the activity, by `base::wall_time` [s]
  /// Fraction that was last shown; below 0 before the activity is first shown.
  double shown_fraction_ = -1;
  double shown_at_ = 0; ///< time at which progress was last shown, by `base::wall_time` [s]
  /// Characters of the bar's unfinished line on the terminal; 0 when there is none.
  std::size_t bar_length_ = 0;
  std::condition_variable_any wake_;
  std::jthread ticker_; ///< thread that updates the time; last member, so that it ends before the
                        ///< members that it uses are destroyed
};

} // namespace ionskin::apps
