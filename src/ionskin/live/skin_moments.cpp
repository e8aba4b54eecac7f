// SPDX-License-Identifier: Apache-2.0

// A step under held moments: the slider tilts until the skin answers with them.

#include "ionskin/live/skin.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ionskin::live {
namespace {

using Pair = std::array<double, 2>;

/// Missed moment, over the force and the reach of the contact cells, at which the search stops, and
/// up to which the moments count as held [1].
constexpr double held_closely = 1e-4, held = 1e-3;
constexpr int most_trials = 30; // contacts that are solved in a step
/// Tilt over the steepest one from which the slider is at the border of what was trained [1].
constexpr double at_border = 1 - 1e-9;

/// Change of roll and pitch by which the moments about x and y change under a held force, which the
/// height follows, docs/model.md (80).
/// @param stiffness as `Skin::stiffness` fills it
/// @param change wanted change of the moments [N m]
Pair tilt_for(const std::array<double, motions * motions>& stiffness, const Pair& change,
              double yaw) {
  constexpr std::size_t down = 2, about_x = 3;
  const auto slope = [&](std::size_t row, std::size_t motion) {
    const auto of = [&](std::size_t i, std::size_t j) { return stiffness[motions * i + j]; };
    return of(row, motion) - of(row, down) * of(down, motion) / of(down, down);
  };
  const double xx = slope(about_x, about_x), xy = slope(about_x, about_x + 1),
               yx = slope(about_x + 1, about_x), yy = slope(about_x + 1, about_x + 1),
               determinant = xx * yy - xy * yx, x = (yy * change[0] - xy * change[1]) / determinant,
               y = (xx * change[1] - yx * change[0]) / determinant;
  return {std::cos(yaw) * x + std::sin(yaw) * y, std::cos(yaw) * y - std::sin(yaw) * x};
}

} // namespace

/// Presses once more from the state that `before_` holds. The compliance stays assembled.
Skin::Pressed Skin::press_again(double time, const Pair& place, const Angles& angles, double force,
                                std::span<double> signals) noexcept {
  const Pair assembled{state_[assembled_x], state_[assembled_y]};
  std::ranges::copy(before_, state_.begin());
  state_[assembled_x] = assembled[0];
  state_[assembled_y] = assembled[1];
  return press(time, place, angles, true, force, signals);
}

std::uint32_t Skin::step_held(double time, const Pair& place, double yaw, double force,
                              const Pair& moments, std::span<double> signals) noexcept {
  if (!std::isfinite(moments[0]) || !std::isfinite(moments[1])) {
    force = std::numeric_limits<double>::quiet_NaN(); // and the step is refused
  }
  std::ranges::copy(state_, before_.begin());
  const double scale = std::min(force, data_.heaviest_force) * reach_;
  Pair tilt{state_[last_roll], state_[last_pitch]}, best = tilt, change{};
  double least = std::numeric_limits<double>::infinity(); // missed moment at the best tilt [N m]
  Pressed pressed;
  for (int trial = 1;; ++trial) {
    pressed = press_again(time, place, {tilt[0], tilt[1], yaw}, force, signals);
    if (!pressed.touches) {
      return finish(pressed, signals);
    }
    const Pair missed{moments[0] - signals[names_.size() - 3],
                      moments[1] - signals[names_.size() - 2]};
    const double left = std::hypot(missed[0], missed[1]);
    if (left < least) {
      least = left;
      best = tilt;
      std::array<double, motions * motions> matrix{};
      if (left <= held_closely * scale || trial == most_trials || !stiffness(matrix)) {
        break;
      }
      change = tilt_for(matrix, missed, yaw);
    } else if (trial < most_trials) {
      change = {change[0] / 2, change[1] / 2};
    } else {
      pressed = press_again(time, place, {best[0], best[1], yaw}, force, signals);
      break;
    }
    tilt = {best[0] + change[0], best[1] + change[1]};
    const double steep = std::hypot(tilt[0], tilt[1]),
                 share = steep > data_.steepest ? data_.steepest / steep : 1;
    tilt = {share * tilt[0], share * tilt[1]};
    if (!std::isfinite(steep) || tilt == best) {
      break;
    }
  }
  if (least > held * scale) {
    const bool limited = std::hypot(best[0], best[1]) >= at_border * data_.steepest;
    pressed.flags |= limited ? flag::outside_pose : flag::unconverged;
  }
  return finish(pressed, signals);
}

} // namespace ionskin::live
