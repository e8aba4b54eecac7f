// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/base/progress.hpp"
#include "options.hpp"

#include <mutex>
#include <string>
#include <string_view>

namespace ionskin::apps {

/// Shows progress on stderr: one bar per activity with the time left on a terminal, a line per
/// activity and every tenth of it in a log, or JSON lines. Safe to call from several threads.
class ProgressDisplay {
public:
  explicit ProgressDisplay(LogFormat format);
  ~ProgressDisplay();
  ProgressDisplay(const ProgressDisplay&) = delete;
  ProgressDisplay& operator=(const ProgressDisplay&) = delete;

  /// @param fraction finished part of the activity in [0, 1]
  void update(std::string_view activity, double fraction);
  /// Updates this display, which must outlive it.
  base::ProgressCallback callback();

private:
  void show_bar(double fraction);
  void show_line(double fraction);
  void show_json(double fraction);
  void end_bar();

  std::mutex mutex_;
  LogFormat format_;
  bool terminal_;
  std::string activity_;
  double start_ = 0;
  double last_shown_ = -1; ///< fraction
  double last_time_ = 0;
  bool bar_open_ = false;
};

} // namespace ionskin::apps
