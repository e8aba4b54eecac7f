// SPDX-License-Identifier: Apache-2.0
#include "ionskin/readout/slip_onset.hpp"

#include <algorithm>
#include <cstddef>

namespace ionskin::readout {
namespace {

struct Point {
  double time = 0, share = 0;
};

/// Sticking share over the slide, from first contact until the contact is lost.
std::vector<Point> stuck_over(const std::vector<double>& time, const std::vector<double>& area,
                              const std::vector<double>& stick_share,
                              const std::array<double, 2>& slide) {
  // Instants of the motion are sums of durations, with rounding errors.
  const double rounding = 1e-12 * time.back();
  std::vector<Point> points;
  for (std::size_t i = 0; i < time.size(); ++i) {
    if (time[i] < slide[0] - rounding || time[i] > slide[1] + rounding) {
      continue;
    }
    if (area[i] > 0) {
      points.push_back({time[i], stick_share[i]});
    } else if (!points.empty()) {
      break;
    }
  }
  return points;
}

/// Instant at which the share falls to a level, by linear interpolation between two points [s].
double passed_at(const Point& before, const Point& after, double level) {
  return before.time +
         (after.time - before.time) * (before.share - level) / (before.share - after.share);
}

} // namespace

SlipState slip_state(double area, double stick_share) {
  if (!(area > 0)) {
    return SlipState::detached;
  }
  if (stick_share >= 1 - micro_slip_share) {
    return SlipState::stick;
  }
  return stick_share > full_slip_share ? SlipState::partial_slip : SlipState::full_slip;
}

std::optional<SlipOnset> find_slip_onset(const std::vector<double>& time,
                                         const std::vector<double>& area,
                                         const std::vector<double>& stick_share,
                                         const std::array<double, 2>& slide) {
  const std::vector<Point> points = stuck_over(time, area, stick_share, slide);
  std::optional<SlipOnset> onset;
  double largest = points.empty() ? 0 : points.front().share;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Point &before = points[i - 1], &after = points[i];
    const double step = after.time - before.time, level = largest - micro_slip_share;
    if (!onset && level > full_slip_share && after.share <= level) {
      onset = SlipOnset{points.front().time, passed_at(before, after, level), {}, step, 0};
    }
    if (onset && after.share <= full_slip_share) {
      onset->full_slip = passed_at(before, after, full_slip_share);
      onset->full_slip_step = step;
      break;
    }
    largest = std::max(largest, after.share);
  }
  return onset;
}

} // namespace ionskin::readout
