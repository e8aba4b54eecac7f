// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/path/expected_steps.hpp"

#include "ionskin/case/slider_motion.hpp"
#include "ionskin/laws/friction/friction_law.hpp"
#include "ionskin/mechanics/path/path_resolution.hpp"
#include "ionskin/mechanics/path/path_steps.hpp"
#include "ionskin/mesh/footprint.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace ionskin::mechanics {
namespace {

/// Expected number of steps of stick-slip, for a slider on a drive under a force. Steady sliding is
/// unstable where the friction force falls with speed more steeply than damping and, within the lag
/// of friction, the spring compensate (Ruina 1983, doi 10.1029/JB088iB12p10359, without a mass).
/// The slider then sticks and slips once for each travel of the drive by twice the fall of friction
/// over the spring's stiffness.
double steps_of_stick_slip(const Case& input, const MotionLeg& leg) {
  constexpr double steps_each = 115; // of one stick and slip, measured
  constexpr double change = 0.01;    // of the speed, for the slope of friction
  constexpr double fast = 100;       // speed of a slip over the speed of the drive
  const Drive& drive = input.motion.drive;
  if (!drive.given() || !leg.to_level.is_force) {
    return 0;
  }
  const double speed = leg.length() / leg.duration,
               force = std::max(leg.from_level.value, leg.to_level.value);
  const laws::Friction law =
      laws::friction(input.contact.law, input.contact.friction, input.contact.parameters);
  const auto friction = [&](double at) { // [N]
    return force *
           law.limit(
               {.normal_traction = 1, .slip_increment = at, .time_step = 1, .lagged_speed = at});
  };
  const double slope =
      (friction((1 + change) * speed) - friction((1 - change) * speed)) / (2 * change * speed);
  const double fall = friction(0) - friction(fast * speed);
  return -slope > drive.damping + drive.stiffness * law.lag && fall > 0
             ? steps_each * leg.length() * drive.stiffness / (2 * fall)
             : 0;
}

/// Expected number of steps of a slider that turns or tilts along a leg.
double steps_of_turn(const Case& input, const MotionLeg& leg, const PathSteps& each,
                     double indentation) {
  if (!leg.turns()) {
    return 0;
  }
  const shapes::Pose &from = leg.from_pose, &to = leg.to_pose;
  const auto half = mesh::expected_footprint(input).half_size;
  const double rise = std::max(std::abs(to.roll - from.roll), std::abs(to.pitch - from.pitch)) *
                      std::hypot(half[0], half[1]);
  return std::ceil(std::max(std::abs(to.yaw - from.yaw) / longest_step_turn(input.numerics),
                            each.touchdown * (indentation > 0 ? rise / indentation : 1.0)));
}

/// Mean of the cost over positions from one x to another [m].
double mean_cost(const std::function<double(double x)>& cost, double from, double to) {
  constexpr int parts = 8;
  double sum = 0;
  for (int i = 0; i < parts; ++i) {
    sum += cost(from + (i + 0.5) / parts * (to - from));
  }
  return sum / parts;
}

} // namespace

ExpectedSteps expected_steps(const Case& input, const std::function<double(double x)>& cost) {
  // Shares of the steps that thinning stores, measured: of steps in general, and of steps along a
  // path whose rows are so close that each takes a single step.
  constexpr double kept_share = 0.5, kept_share_of_rows = 0.22;
  const PathSteps each;
  const mesh::HeaviestLoad heaviest = mesh::heaviest_load(input);
  const double travel_each = longest_step_travel(input);
  std::array<double, 2> direction{};
  double steps = 0, rows = 0, across = 0, of_places = 0;
  for (const MotionLeg& leg : motion_legs(input.motion, input.slider)) {
    if (!leg.touches()) {
      continue;
    }
    const ContactPart part = contact_part(leg);
    const double change = std::abs(part.to_level.value - part.from_level.value),
                 largest = part.to_level.is_force ? heaviest.force : heaviest.indentation;
    double of_level = 0;
    if (leg.lands() || leg.leaves() || part.from_level.is_force != part.to_level.is_force) {
      of_level = leg.leaves() ? each.lift_off : each.touchdown;
    } else if (largest > 0) {
      of_level = std::ceil(each.touchdown * change / largest);
    }
    of_level = std::max(of_level, steps_of_turn(input, leg, each, heaviest.indentation));
    if (!leg.slides()) {
      direction = {};
      steps += of_level;
      of_places += cost ? of_level * cost(leg.from[0]) : 0;
      continue;
    }
    const auto way = leg.direction();
    if (way[0] * direction[0] + way[1] * direction[1] < std::cos(sharp_turn)) {
      steps += each.onset;
      of_places += cost ? each.onset * cost(leg.from[0]) : 0;
      across += way[1] != 0 ? each.onset : 0;
    }
    direction = way;
    // One step changes position and level at the same time.
    const double of_leg =
        std::max(of_level, std::ceil(leg.length() / travel_each)) + steps_of_stick_slip(input, leg);
    (of_leg <= 1 ? rows : steps) += of_leg;
    of_places += cost ? of_leg * mean_cost(cost, leg.from[0], leg.to[0]) : 0;
    across += way[1] != 0 ? of_leg : 0;
  }
  const auto count = [](double number) { return static_cast<std::size_t>(std::min(number, 1e9)); };
  return {count(steps + rows), count(kept_share * steps + kept_share_of_rows * rows), count(across),
          of_places};
}

} // namespace ionskin::mechanics
