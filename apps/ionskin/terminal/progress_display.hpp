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

/// Shows progress on stderr: a bar as wide as the terminal, lines in a log, JSON lines, or nothing.
/// It only goes forward, and goes on telling the time while the work is silent. Safe to call from
/// several threads.
class ProgressDisplay {
public:
  explicit ProgressDisplay(LogFormat format);
  ~ProgressDisplay();
  ProgressDisplay(const ProgressDisplay&) = delete;
  ProgressDisplay& operator=(const ProgressDisplay&) = delete;

  /// Shows how far an activity is.
  /// @param fraction finished part of the activity in [0, 1]; less than before is taken as before,
  /// but after 1, which begins the activity anew
  void update(std::string_view activity, double fraction);
  /// Shows a line for readers between the others; JSON lines, and nothing, stay what they are.
  void tell(const std::string& text);
  /// Updates this display, which must outlive it.
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
  double start_ = 0;           ///< of the activity
  double shown_fraction_ = -1; ///< below 0 before the activity is first shown
  double shown_at_ = 0;
  std::size_t bar_length_ = 0; ///< of the unfinished line on the terminal; 0 when there is none
  std::condition_variable_any wake_;
  std::jthread ticker_; ///< last, so that it ends before what it uses
};

} // namespace ionskin::apps
