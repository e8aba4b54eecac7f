// SPDX-License-Identifier: Apache-2.0
#include "terminal/progress_display.hpp"

#include "ionskin/base/system/blocked_signal.hpp"
#include "ionskin/base/timers.hpp"
#include "terminal/terminal.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <unistd.h>

namespace ionskin::apps {
namespace {

constexpr double bar_interval = 0.1;   // [s] at least between two pictures of the bar
constexpr double line_interval = 1.0;  // [s] at least between two lines of a log ...
constexpr double line_step = 0.1;      // ... and this much progress,
constexpr double silence_at_most = 30; // [s] or this time
constexpr double json_step = 0.01;
constexpr auto tick_interval = std::chrono::seconds(1);

LogFormat settled(LogFormat format) {
  if (format != LogFormat::automatic) {
    return format;
  }
  const char* terminal = std::getenv("TERM");
  const bool dumb = terminal != nullptr && std::string(terminal) == "dumb";
  return isatty(STDERR_FILENO) != 0 && !dumb ? LogFormat::bar : LogFormat::lines;
}

/// Writes a text to stderr; a closed terminal does not end the run.
void put(const std::string& text) {
  std::fputs(text.c_str(), stderr);
}

} // namespace

ProgressDisplay::ProgressDisplay(LogFormat format) : format_(settled(format)) {
  if (format_ == LogFormat::bar || format_ == LogFormat::lines) {
    const base::BlockedSignal for_the_main_thread(SIGTERM);
    ticker_ = std::jthread([this](const std::stop_token& stop) { tick(stop); });
  }
}

ProgressDisplay::~ProgressDisplay() {
  if (ticker_.joinable()) {
    ticker_.request_stop();
    ticker_.join();
  }
  end_bar();
}

void ProgressDisplay::update(std::string_view activity, double fraction) {
  const std::lock_guard lock(mutex_);
  const bool again = state_.fraction >= 1 && fraction < 1;
  if (activity != state_.activity || again) {
    begin(activity);
  }
  const bool finished_before = state_.fraction >= 1;
  state_.fraction = std::clamp(fraction, state_.fraction, 1.0);
  if (!finished_before) {
    show(state_.fraction >= 1 || shown_fraction_ < 0);
  }
}

void ProgressDisplay::tell(const std::string& text) {
  const std::lock_guard lock(mutex_);
  if (format_ == LogFormat::bar || format_ == LogFormat::lines) {
    end_bar();
    put(text + "\n");
    std::fflush(stderr);
  }
}

base::ProgressCallback ProgressDisplay::callback() {
  return [this](std::string_view activity, double fraction) { update(activity, fraction); };
}

void ProgressDisplay::begin(std::string_view activity) {
  end_bar();
  state_ = {std::string(activity), 0, 0};
  start_ = base::wall_time();
  shown_fraction_ = -1;
}

void ProgressDisplay::show(bool forced) {
  state_.elapsed = base::wall_time() - start_;
  switch (format_) {
  case LogFormat::automatic:
  case LogFormat::bar:
    return show_bar(forced);
  case LogFormat::lines:
    return show_line(forced);
  case LogFormat::json:
    return show_json(forced);
  case LogFormat::none:
  case LogFormat::quiet:
    return;
  }
}

void ProgressDisplay::show_bar(bool forced) {
  const double now = base::wall_time();
  if (!forced && now - shown_at_ < bar_interval) {
    return;
  }
  shown_at_ = now;
  shown_fraction_ = state_.fraction;
  // Many terminals wrap once the last column is filled.
  const std::size_t columns = terminal_width(STDERR_FILENO) - 1;
  const std::string line = bar_line(state_, columns);
  put(fmt::format("\r{:<{}}", line, std::min(bar_length_, columns)));
  std::fflush(stderr);
  bar_length_ = line.size();
  if (state_.fraction >= 1) {
    end_bar();
  }
}

void ProgressDisplay::show_line(bool forced) {
  const double now = base::wall_time(), since = now - shown_at_;
  const bool further =
      state_.fraction - shown_fraction_ >= line_step - 1e-9 && since >= line_interval;
  if (!forced && !further && since < silence_at_most) {
    return;
  }
  shown_at_ = now;
  shown_fraction_ = state_.fraction;
  put(log_line(state_) + "\n");
  std::fflush(stderr);
}

void ProgressDisplay::show_json(bool forced) {
  if (!forced && state_.fraction - shown_fraction_ < json_step) {
    return;
  }
  shown_fraction_ = state_.fraction;
  put(json_line(state_) + "\n");
  std::fflush(stderr);
}

void ProgressDisplay::end_bar() {
  if (bar_length_ > 0) {
    put("\n");
    bar_length_ = 0;
  }
}

void ProgressDisplay::tick(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  while (!wake_.wait_for(lock, stop, tick_interval, [&stop] { return stop.stop_requested(); })) {
    if (shown_fraction_ >= 0 && state_.fraction < 1) {
      show(false);
    }
  }
}

} // namespace ionskin::apps
