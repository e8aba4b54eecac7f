// SPDX-License-Identifier: Apache-2.0
#include "terminal/progress_line.hpp"

#include "terminal/terminal.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace ionskin::apps {
namespace {

constexpr double least_known_fraction =
    0.02;                              // of the work, before it tells how long the rest takes
constexpr std::size_t name_width = 28; // of the longest name, and a blank
constexpr std::size_t time_width = 16; // of "59 min 59 s left"
constexpr std::size_t least_bar = 5, longest_bar = 30;

/// Text of a percentage, rounded down, so that 100 % appears only at the end.
std::string percentage(double fraction) {
  return fmt::format("{:3} %", static_cast<int>(100 * fraction));
}

std::string bar(double fraction, std::size_t width) {
  const auto filled = static_cast<std::size_t>(fraction * static_cast<double>(width));
  return fmt::format("[{}{}]", std::string(filled, '#'), std::string(width - filled, '.'));
}

std::string time_text(const ProgressState& state) {
  if (state.fraction >= 1) {
    return state.elapsed < 60 ? fmt::format("{:.1f} s", state.elapsed)
                              : duration_text(state.elapsed);
  }
  return state.time_left_known() ? duration_text(state.time_left()) + " left"
                                 : duration_text(state.elapsed) + " so far";
}

} // namespace

bool ProgressState::time_left_known() const {
  return fraction > least_known_fraction;
}

double ProgressState::time_left() const {
  return elapsed * (1 - fraction) / fraction;
}

std::string bar_line(const ProgressState& state, std::size_t columns) {
  const std::string percent = percentage(state.fraction), time = time_text(state);
  const std::string tail = fmt::format("{}  {:<{}}", percent, time, time_width);
  const std::size_t beside_bar = name_width + std::string("[] ").size() + tail.size();
  if (state.activity.size() < name_width && columns >= beside_bar + least_bar) {
    const std::size_t width = std::min(longest_bar, columns - beside_bar);
    return fmt::format("{:<{}}{} {}", state.activity, name_width, bar(state.fraction, width), tail);
  }
  const std::size_t room = columns - std::min(columns, percent.size() + 1);
  const std::string name = state.activity.substr(0, room);
  std::string line = fmt::format("{} {}", name, percent);
  if (line.size() + 2 + time.size() <= columns) {
    line += "  " + time;
  }
  return line;
}

std::string log_line(const ProgressState& state) {
  const bool left = state.fraction < 1 && state.time_left_known();
  return fmt::format("{}: {} % after {:.1f} s{}", state.activity,
                     static_cast<int>(100 * state.fraction), state.elapsed,
                     left ? ", about " + duration_text(state.time_left()) + " left" : "");
}

std::string json_line(const ProgressState& state) {
  const nlohmann::json left =
      state.time_left_known() ? nlohmann::json(state.time_left()) : nlohmann::json();
  return nlohmann::json{{"activity", state.activity},
                        {"fraction", state.fraction},
                        {"elapsed_s", state.elapsed},
                        {"time_left_s", left}}
      .dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

} // namespace ionskin::apps
