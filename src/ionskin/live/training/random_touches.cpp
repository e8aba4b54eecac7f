// SPDX-License-Identifier: Apache-2.0
#include "ionskin/live/training/random_touches.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/live/training/random_numbers.hpp"
#include "ionskin/mechanics/path/contact_box.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

namespace ionskin::live {
namespace {

constexpr double clearance = 1e-4; ///< height of the slider above the skin between touches [m]
/// Number of rows after a corner of the path, a millisecond apart: about the duration of the
/// longest onset of sliding.
constexpr int rows_behind_corner = 50;
constexpr double milliseconds = 1e3; ///< milliseconds in a second
constexpr double least_load = 0.15;  ///< smallest load of a touch over the heaviest one [1]
constexpr double least_speed = 0.1;  ///< smallest speed of a stroke over the fastest one [1]
/// Shortest and longest duration of a landing or a lift-off [s]: from a step of a loop on.
constexpr double fastest_landing = 1e-3, slowest_landing = 0.1;
constexpr double pause = 0.2;        ///< duration between touches [s]
constexpr double usual_speed = 3e-3; ///< speed for a case whose slider never slides [m/s]
constexpr double rest_share = 0.25;  ///< probability of a rest where a touch may have either [1]
/// Probability that a stroke after another stroke goes back along it [1].
constexpr double turning_back_share = 0.3;
constexpr double shortest_rest = 0.1, longest_rest = 0.5; ///< durations of a rest [s]
/// Shortest and longest duration of a load step, and of the rest behind it [s].
constexpr double fastest_load_step = 1e-3, slowest_load_step = 0.01;
constexpr double shortest_settling = 0.06, longest_settling = 0.2;
/// Shortest way back along the stroke before, over its length [1].
constexpr double shortest_reversal = 0.2;
/// Probability that a stroke changes the tilt, and that it changes the yaw; and probability that a
/// stroke stays in place where poses are trained and the touch has another stroke [1].
constexpr double posing_share = 0.5, in_place_share = 0.3;
constexpr double tilting = 0.1; ///< duration of a tilt to a side in the first touch [s]
/// Numbers of pieces (strokes and rests) of a touch.
constexpr int fewest_pieces = 2, most_pieces = 4;

/// Draws a duration whose logarithm is uniformly distributed [s].
double duration_between(Random& random, double shortest, double longest) {
  return shortest * std::pow(longest / shortest, random.between(0, 1));
}

/// Motion of the slider, built one waypoint after the other.
class Path {
public:
  explicit Path(const TouchRange& range) : range_(range) {}

  /// Adds a waypoint above the skin, some time after the last one [s].
  void detached(double wait, const std::array<double, 2>& place) {
    add(wait, place);
    motion.waypoints.back().height = clearance;
  }
  /// Adds a waypoint in contact, some time after the last one [s].
  /// @param load force [N] or indentation [m], as the range says
  void pressed(double wait, const std::array<double, 2>& place, double load) {
    add(wait, place);
    if (range_.is_force) {
      motion.waypoints.back().force = load;
    } else {
      motion.waypoints.back().height = -load;
    }
  }
  Motion motion;
  shapes::Pose pose; ///< pose of the waypoints that are added from now on

private:
  /// Adds a waypoint at a whole millisecond, where a loop steps: it would cut off a corner between
  /// two of its steps.
  void add(double wait, const std::array<double, 2>& place) {
    time_ += motion.waypoints.empty() ? 0 : std::ceil(milliseconds * wait);
    motion.waypoints.push_back({time_ / milliseconds, place, {}, {}, 0});
    if (range_.poses()) {
      Waypoint& row = motion.waypoints.back();
      row.roll = pose.roll;
      row.pitch = pose.pitch;
      row.yaw = pose.yaw;
    }
  }
  const TouchRange& range_;
  double time_ = 0; ///< [ms]
};

} // namespace

TouchRange touch_range(const Case& input) {
  const auto box = mechanics::contact_box(input);
  if (!box) {
    throw UserError("the slider never touches the skin: there is nothing to train\n"
                    "  = lower the slider, such as by a larger motion.preload");
  }
  TouchRange range{*box, false, 0, 0};
  for (const MotionLeg& leg : motion_legs(input.motion, input.slider)) {
    for (const SliderLevel& level : {leg.from_level, leg.to_level}) {
      if (level.touches() && level.is_force != range.is_force) {
        range.is_force = level.is_force; // a force takes precedence over a height
        range.heaviest = 0;
      }
      if (level.touches() && level.is_force == range.is_force) {
        range.heaviest = std::max(range.heaviest, std::abs(level.value));
      }
    }
    if (leg.slides()) {
      range.fastest = std::max(range.fastest, leg.length() / leg.duration);
    }
  }
  if (range.fastest == 0) {
    range.fastest = usual_speed;
  }
  return range;
}

std::vector<double> landings(const Motion& motion) {
  std::vector<double> times;
  for (std::size_t i = 0; i + 1 < motion.waypoints.size(); ++i) {
    const auto lifted = [&](const Waypoint& point) { return point.height.value_or(-1) > 0; };
    if (lifted(motion.waypoints[i]) && !lifted(motion.waypoints[i + 1])) {
      times.push_back(motion.waypoints[i].time);
    }
  }
  return times;
}

Motion with_rows_behind_corners(const Motion& motion) {
  Motion dense = motion;
  dense.waypoints.clear();
  for (const Waypoint& to : motion.waypoints) {
    if (!dense.waypoints.empty()) {
      const Waypoint from = dense.waypoints.back();
      const bool forces = from.force && to.force,
                 heights = from.height.value_or(1) < 0 && to.height.value_or(1) < 0;
      const double duration = to.time - from.time;
      const int rows = forces || heights
                           ? std::min(rows_behind_corner,
                                      static_cast<int>(std::lround(duration * milliseconds)) - 1)
                           : 0;
      for (int row = 1; row <= rows; ++row) {
        const double weight = row / milliseconds / duration;
        Waypoint between = to;
        between.time = (std::round(from.time * milliseconds) + row) / milliseconds;
        for (std::size_t d = 0; d < 2; ++d) {
          between.position[d] = from.position[d] + weight * (to.position[d] - from.position[d]);
        }
        const auto turn = [&](std::optional<double> Waypoint::*angle) {
          if (to.*angle) {
            between.*angle = *(from.*angle) + weight * (*(to.*angle) - *(from.*angle));
          }
        };
        turn(&Waypoint::roll);
        turn(&Waypoint::pitch);
        turn(&Waypoint::yaw);
        if (forces) {
          between.force = *from.force + weight * (*to.force - *from.force);
        } else {
          between.height = *from.height + weight * (*to.height - *from.height);
        }
        dense.waypoints.push_back(between);
      }
    }
    dense.waypoints.push_back(to);
  }
  return dense;
}

Motion random_touches(const TouchRange& range, std::size_t count, std::uint64_t seed) {
  // Load steps are drawn apart, so that the rest of the motion is that without them.
  Random random(seed), of_load_steps(~seed);
  Path path(range);
  path.motion.kind = MotionKind::waypoints;
  const std::array<double, 2>& low = range.box.low;
  const std::array<double, 2>& high = range.box.high;
  const auto place = [&]() -> std::array<double, 2> {
    const double x = random.between(low[0], high[0]);
    return {x, random.between(low[1], high[1])};
  };
  const auto wait_between = [&](const std::array<double, 2>& a, const std::array<double, 2>& b) {
    const double way = std::hypot(b[0] - a[0], b[1] - a[1]);
    return std::max(0.05, way / (range.fastest * random.between(least_speed, 1)));
  };
  const auto tilt = [&] {
    const double share = range.steepest * std::sqrt(random.between(0, 1)),
                 towards = random.between(0, 2 * std::numbers::pi);
    path.pose.roll = share * std::cos(towards);
    path.pose.pitch = share * std::sin(towards);
  };
  // Draws the pose at the end of a stroke of a given duration; no random numbers are used for
  // angles that are not trained.
  const auto pose = [&](double duration) {
    if (range.steepest > 0 && random.between(0, 1) < posing_share) {
      tilt();
    }
    if (range.fastest_turn > 0 && random.between(0, 1) < posing_share) {
      path.pose.yaw += range.fastest_turn * duration * random.between(-1, 1);
    }
  };
  // The path goes from corner to corner along the diagonal, which spans the range.
  path.detached(0, low);
  path.pressed(0.5, low, range.heaviest);
  const double way = std::hypot(high[0] - low[0], high[1] - low[1]);
  if (way > 0) {
    path.pressed(way / range.fastest, high, range.heaviest);
  }
  if (range.steepest > 0) {
    for (const auto& [roll, pitch] : {std::pair{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {0, 0}}) {
      path.pose = {roll * range.steepest, pitch * range.steepest, 0};
      path.pressed(tilting, high, range.heaviest);
    }
  }
  path.detached(0.5, high);
  for (std::size_t touch = 1; touch < count; ++touch) {
    std::array<double, 2> at = place();
    if (range.steepest > 0) {
      tilt();
    }
    path.detached(pause, at);
    double load = range.heaviest * random.between(least_load, 1);
    path.pressed(duration_between(random, fastest_landing, slowest_landing), at, load);
    const int pieces = static_cast<int>(random.between(fewest_pieces, most_pieces + 1));
    const int rest = static_cast<int>(random.between(0, pieces)),
              stroke = (rest + static_cast<int>(random.between(1, pieces))) % pieces;
    std::array<double, 2> from = at; // start of the last piece
    for (int piece = 0; piece < pieces; ++piece) {
      if (piece == rest || (piece != stroke && random.between(0, 1) < rest_share)) {
        path.pressed(random.between(shortest_rest, longest_rest), at, load);
        if (piece == rest) {
          load = range.heaviest * of_load_steps.between(least_load, 1);
          path.pressed(duration_between(of_load_steps, fastest_load_step, slowest_load_step), at,
                       load);
          path.pressed(of_load_steps.between(shortest_settling, longest_settling), at, load);
        }
        from = at;
      } else {
        std::array<double, 2> to = place();
        if (from != at && random.between(0, 1) < turning_back_share) {
          const double back = random.between(shortest_reversal, 1);
          to = {std::lerp(at[0], from[0], back), std::lerp(at[1], from[1], back)};
        }
        from = at;
        load = random.between(0, 1) < 0.5 ? load : range.heaviest * random.between(least_load, 1);
        if (range.poses() && piece != stroke && random.between(0, 1) < in_place_share) {
          to = at;
        }
        const double wait = wait_between(at, to);
        pose(wait);
        path.pressed(wait, to, load);
        at = to;
      }
    }
    path.detached(duration_between(random, fastest_landing, slowest_landing), at);
  }
  path.detached(pause, path.motion.waypoints.back().position);
  return path.motion;
}

} // namespace ionskin::live
