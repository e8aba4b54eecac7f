// SPDX-License-Identifier: Apache-2.0
#include "ionskin/live/touches/random_touches.hpp"

#include "ionskin/live/touches/random_numbers.hpp"

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
constexpr double pause = 0.2;       ///< duration between touches [s]
constexpr double rest_share = 0.25; ///< probability of a rest where a touch may have either [1]
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
constexpr double tilting = 0.1;      ///< duration of a tilt to a side in the first touch [s]
constexpr double quarter_turn = 0.5; ///< duration of a quarter turn there [s]
/// Numbers of pieces (strokes and rests) of a touch.
constexpr int fewest_pieces = 2, most_pieces = 4;

/// Draws a duration whose logarithm is uniformly distributed [s].
double duration_between(Random& random, double shortest, double longest) {
  return shortest * std::pow(longest / shortest, random.between(0, 1));
}

/// Motion of the slider, built one waypoint after the other.
class Path {
public:
  explicit Path(const TouchRange& range) : range_(range) { motion.kind = MotionKind::waypoints; }

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

/// Draws touches within a range, one after the other.
class RandomPath {
public:
  RandomPath(const TouchRange& range, std::uint64_t seed)
      : range_(range), random_(seed), of_load_steps_(~seed), path_(range) {}

  /// Goes from corner to corner along the diagonal, which spans the range, under the heaviest load.
  void through_the_corners() {
    const std::array<double, 2>&low = range_.box.low, &high = range_.box.high;
    path_.detached(0, low);
    path_.pressed(0.5, low, range_.heaviest);
    const double way = std::hypot(high[0] - low[0], high[1] - low[1]);
    if (way > 0) {
      path_.pressed(way / range_.fastest, high, range_.heaviest);
    }
    if (range_.steepest > 0) {
      for (const auto& [roll, pitch] : {std::pair{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {0, 0}}) {
        path_.pose = {roll * range_.steepest, pitch * range_.steepest, 0};
        path_.pressed(tilting, high, range_.heaviest);
      }
    }
    if (range_.any_yaw) {
      for (int quarter = 1; quarter <= 4; ++quarter) {
        path_.pose.yaw = quarter * std::numbers::pi / 2;
        path_.pressed(quarter_turn, high, range_.heaviest);
      }
    }
    path_.detached(0.5, high);
  }

  /// Waits above the skin, lands, makes strokes and rests, and lifts off.
  void touch() {
    std::array<double, 2> at = place();
    if (range_.steepest > 0) {
      tilt();
    }
    if (range_.any_yaw) {
      path_.pose.yaw = 2 * std::numbers::pi * random_.between(0, 1);
    }
    if (path_.motion.waypoints.empty()) {
      path_.detached(0, at);
    }
    path_.detached(pause, at);
    double load = range_.heaviest * random_.between(least_load, 1);
    path_.pressed(duration_between(random_, fastest_landing, slowest_landing), at, load);
    const int pieces = static_cast<int>(random_.between(fewest_pieces, most_pieces + 1));
    const int rest = static_cast<int>(random_.between(0, pieces)),
              stroke = (rest + static_cast<int>(random_.between(1, pieces))) % pieces;
    std::array<double, 2> from = at; // start of the last piece
    for (int piece = 0; piece < pieces; ++piece) {
      if (piece == rest || (piece != stroke && random_.between(0, 1) < rest_share)) {
        path_.pressed(random_.between(shortest_rest, longest_rest), at, load);
        if (piece == rest) {
          load = load_step(at);
        }
        from = at;
      } else {
        std::array<double, 2> to = place();
        if (from != at && random_.between(0, 1) < turning_back_share) {
          const double back = random_.between(shortest_reversal, 1);
          to = {std::lerp(at[0], from[0], back), std::lerp(at[1], from[1], back)};
        }
        from = at;
        load =
            random_.between(0, 1) < 0.5 ? load : range_.heaviest * random_.between(least_load, 1);
        if (range_.poses() && piece != stroke && random_.between(0, 1) < in_place_share) {
          to = at;
        }
        const double stroke_duration = duration(at, to);
        pose(stroke_duration);
        path_.pressed(stroke_duration, to, load);
        at = to;
      }
    }
    path_.detached(duration_between(random_, fastest_landing, slowest_landing), at);
  }

  /// The motion so far, ended by a pause above the skin.
  Motion ended() {
    path_.detached(pause, path_.motion.waypoints.back().position);
    return path_.motion;
  }

private:
  std::array<double, 2> place() {
    const double x = random_.between(range_.box.low[0], range_.box.high[0]);
    return {x, random_.between(range_.box.low[1], range_.box.high[1])};
  }
  /// Draws the duration of a stroke [s].
  double duration(const std::array<double, 2>& from, const std::array<double, 2>& to) {
    const double way = std::hypot(to[0] - from[0], to[1] - from[1]);
    return std::max(0.05, way / (range_.fastest * random_.between(least_speed, 1)));
  }
  void tilt() {
    const double share = range_.steepest * std::sqrt(random_.between(0, 1)),
                 towards = random_.between(0, 2 * std::numbers::pi);
    path_.pose.roll = share * std::cos(towards);
    path_.pose.pitch = share * std::sin(towards);
  }
  /// Draws the pose at the end of a stroke of some duration [s]; no random numbers are used for
  /// angles that are not trained.
  void pose(double duration) {
    if (range_.steepest > 0 && random_.between(0, 1) < posing_share) {
      tilt();
    }
    if (range_.fastest_turn > 0 && random_.between(0, 1) < posing_share) {
      path_.pose.yaw += range_.fastest_turn * duration * random_.between(-1, 1);
    }
  }
  /// Steps the load in a rest at a place, and returns the new load.
  double load_step(const std::array<double, 2>& at) {
    const double load = range_.heaviest * of_load_steps_.between(least_load, 1);
    path_.pressed(duration_between(of_load_steps_, fastest_load_step, slowest_load_step), at, load);
    path_.pressed(of_load_steps_.between(shortest_settling, longest_settling), at, load);
    return load;
  }

  const TouchRange& range_;
  Random random_, of_load_steps_; ///< load steps are drawn apart: the rest is that without them
  Path path_;
};

} // namespace

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
  RandomPath path(range, seed);
  path.through_the_corners();
  for (std::size_t touch = 1; touch < count; ++touch) {
    path.touch();
  }
  return path.ended();
}

Motion random_touch(const TouchRange& range, std::uint64_t seed) {
  RandomPath path(range, seed);
  path.touch();
  return path.ended();
}

} // namespace ionskin::live
