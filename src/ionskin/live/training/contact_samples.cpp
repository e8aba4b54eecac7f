// SPDX-License-Identifier: Apache-2.0
#include "ionskin/live/training/contact_samples.hpp"

#include "ionskin/base/system/interrupt.hpp"
#include "ionskin/live/contact/live_contact.hpp"
#include "ionskin/live/data/slope_table.hpp"
#include "ionskin/live/touches/random_numbers.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace ionskin::live {
namespace {

constexpr double sample_step = 1e-3; // [s]
constexpr double lightest_share = 0.1, slowest_share = 0.1;
constexpr double resting_share = 0.3, same_load_share = 0.5, reversal_share = 0.3;
constexpr double fewest_steps = 10, most_landing_steps = 80, most_steps = 150;
constexpr double most_legs = 5;
constexpr double posing_piece_share = 0.5; // of the strokes that tilt, or turn
constexpr int frictions = 5;               // of a range
constexpr int steps_a_sample = 24;         // on average: neighbours tell little more

} // namespace

std::vector<std::vector<double>> contact_samples(const SkinData& data, const TouchRange& range,
                                                 std::size_t count, std::uint64_t seed) {
  Random random(seed);
  LiveContact contact(data);
  const std::size_t size = 3 * data.area.size();
  std::vector<double> force(size), surface(size), memory(contact.memory_size());
  const double nowhere = std::numeric_limits<double>::quiet_NaN();
  double indentation = 0, assembled_x = nowhere, assembled_y = nowhere;
  const auto& [low, high] = range.box;
  std::array<double, 2> at{}, direction{1, 0};
  std::vector<std::vector<double>> samples;
  LiveContact::Stance stance;
  std::array<double, 2> slope_way{}; // of a step
  double turn = 0;
  const auto press = [&](const std::array<double, 2>& place, double load) {
    if (data.steepest > 0) {
      const double steepest = std::tan(data.steepest);
      for (std::size_t d = 0; d < 2; ++d) {
        stance.slope[d] += slope_way[d];
      }
      const double length = std::hypot(stance.slope[0], stance.slope[1]);
      for (double& slope : stance.slope) {
        slope *= length > steepest ? steepest / length : 1;
      }
      const double c = std::cos(stance.yaw), s = std::sin(stance.yaw);
      stance.lowest = at_slope(
          data.slopes, data.lowest,
          {c * stance.slope[0] + s * stance.slope[1], c * stance.slope[1] - s * stance.slope[0]});
    }
    stance.turn = turn;
    stance.yaw += range.any_yaw ? turn : 0;
    contact.step(sample_step, place, {place[0] - at[0], place[1] - at[1]}, stance,
                 {range.is_force, load},
                 {force, surface, memory, indentation, assembled_x, assembled_y});
    at = place;
    if (load > 0 && samples.size() < count && random.between(0, steps_a_sample) < 1) {
      samples.push_back(force);
    }
  };
  const auto load = [&] {
    return range.heaviest * (range.is_force ? data.meshed_share : 1) *
           random.between(lightest_share, 1);
  };
  const auto slope = [&] {
    const double share = std::tan(data.steepest) * std::sqrt(random.between(0, 1)),
                 towards = random.between(0, 2 * std::numbers::pi);
    return std::array{share * std::cos(towards), share * std::sin(towards)};
  };
  // No pose is drawn that is not trained.
  const auto pose = [&](bool rests, double length) {
    slope_way = {};
    turn = 0;
    if (data.steepest > 0 && !rests && random.between(0, 1) < posing_piece_share) {
      const std::array<double, 2> to = slope();
      for (std::size_t d = 0; d < 2; ++d) {
        slope_way[d] = (to[d] - stance.slope[d]) / length;
      }
    }
    if (data.fastest_turn > 0 && !rests && random.between(0, 1) < posing_piece_share) {
      turn = sample_step * data.fastest_turn * random.between(-1, 1);
    }
  };
  for (int touch = 0; samples.size() < count; ++touch) {
    base::check_interrupt();
    contact.set_friction(std::lerp(data.lowest_friction, data.highest_friction,
                                   static_cast<double>(touch % frictions) / (frictions - 1)));
    for (std::size_t d = 0; d < 2; ++d) {
      at[d] = random.between(low[d], high[d]);
    }
    pose(true, 1);
    if (data.steepest > 0) {
      stance.slope = slope();
    }
    if (range.any_yaw) {
      stance.yaw = random.between(0, 2 * std::numbers::pi);
    }
    press(at, 0);
    double now = load();
    const auto steps = [&](double most) { return std::floor(random.between(fewest_steps, most)); };
    const double landing = steps(most_landing_steps);
    for (double i = 1; i <= landing; ++i) {
      press(at, now * i / landing);
    }
    const double pieces = std::floor(random.between(1, most_legs + 1));
    for (double piece = 0; piece < pieces; ++piece) {
      const double from = now, length = steps(most_steps);
      const bool rests = random.between(0, 1) < resting_share;
      if (random.between(0, 1) < reversal_share) {
        direction = {-direction[0], -direction[1]};
      } else {
        const double angle = random.between(0, 2 * std::numbers::pi);
        direction = {std::cos(angle), std::sin(angle)};
      }
      pose(rests, length);
      const double way = rests ? 0 : sample_step * range.fastest * random.between(slowest_share, 1);
      now = random.between(0, 1) < same_load_share ? now : load();
      for (double i = 1; i <= length; ++i) {
        std::array<double, 2> to{};
        for (std::size_t d = 0; d < 2; ++d) {
          to[d] = std::clamp(at[d] + way * direction[d], low[d], high[d]);
        }
        press(to, std::lerp(from, now, i / length));
      }
    }
  }
  return samples;
}

} // namespace ionskin::live
