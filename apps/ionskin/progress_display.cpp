// SPDX-License-Identifier: Apache-2.0
#include "progress_display.hpp"

#include "ionskin/base/timers.hpp"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <unistd.h>

namespace ionskin::apps {
namespace {

constexpr int bar_width = 30;
constexpr double bar_interval = 0.1; // [s] between two pictures of the bar

} // namespace

ProgressDisplay::ProgressDisplay(LogFormat format)
    : format_(format), terminal_(isatty(STDERR_FILENO) != 0) {}

ProgressDisplay::~ProgressDisplay() {
  end_bar();
}

void ProgressDisplay::update(std::string_view activity, double fraction) {
  if (format_ == LogFormat::quiet) {
    return;
  }
  const std::lock_guard lock(mutex_);
  if (activity != activity_) {
    end_bar();
    activity_ = activity;
    start_ = base::wall_time();
    last_shown_ = -1;
    last_time_ = 0;
  }
  if (format_ == LogFormat::json) {
    show_json(fraction);
  } else if (terminal_) {
    show_bar(fraction);
  } else {
    show_line(fraction);
  }
}

base::ProgressCallback ProgressDisplay::callback() {
  return [this](std::string_view activity, double fraction) { update(activity, fraction); };
}

void ProgressDisplay::show_bar(double fraction) {
  const double now = base::wall_time();
  if (fraction < 1 && now - last_time_ < bar_interval) {
    return;
  }
  last_time_ = now;
  const double elapsed = now - start_;
  const auto filled = static_cast<std::size_t>(std::clamp(fraction, 0.0, 1.0) * bar_width);
  std::string left;
  if (fraction >= 1) {
    left = fmt::format("{:.1f} s", elapsed);
  } else if (fraction > 0.02) {
    left = fmt::format("{:.0f} s left", elapsed * (1 - fraction) / fraction);
  }
  fmt::print(stderr, "\r{:<34} [{}{}] {:3.0f} %  {:<12}", activity_, std::string(filled, '#'),
             std::string(bar_width - filled, '.'), 100 * fraction, left);
  std::fflush(stderr);
  bar_open_ = true;
  if (fraction >= 1) {
    end_bar();
  }
}

void ProgressDisplay::show_line(double fraction) {
  const double tenth = std::max(0.0, static_cast<int>(fraction * 10) / 10.0);
  if (tenth <= last_shown_) {
    return;
  }
  last_shown_ = tenth;
  fmt::print(stderr, "{}: {:.0f} % after {:.1f} s\n", activity_, 100 * fraction,
             base::wall_time() - start_);
}

void ProgressDisplay::show_json(double fraction) {
  if (fraction < 1 && fraction - last_shown_ < 0.01) {
    return;
  }
  last_shown_ = fraction;
  const nlohmann::json line{
      {"activity", activity_}, {"fraction", fraction}, {"elapsed_s", base::wall_time() - start_}};
  fmt::print(stderr, "{}\n", line.dump());
}

void ProgressDisplay::end_bar() {
  if (bar_open_) {
    fmt::print(stderr, "\n");
    bar_open_ = false;
  }
}

} // namespace ionskin::apps
