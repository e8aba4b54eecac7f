// SPDX-License-Identifier: Apache-2.0
#include "ionskin/shapes/profile.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace ionskin::shapes {
namespace {

/// Largest distance from the centre, within +-half, at which a profile line lies below a level [m];
/// 0 if it does not.
/// @param places, heights points of the line, linear in between [m]
double reach_below(const std::vector<double>& places, const std::vector<double>& heights,
                   double level, double half) {
  double reach = 0;
  for (std::size_t i = 1; i < places.size(); ++i) {
    const double low = std::max(places[i - 1], -half), high = std::min(places[i], half);
    const double slope = (heights[i] - heights[i - 1]) / (places[i] - places[i - 1]);
    const double at_low = heights[i - 1] + slope * (low - places[i - 1]),
                 at_high = heights[i - 1] + slope * (high - places[i - 1]);
    if (low >= high || std::min(at_low, at_high) >= level) {
      continue;
    }
    const double crossing = slope == 0 ? low : low + (level - at_low) / slope;
    reach = std::max({reach, std::abs(at_low < level ? low : crossing),
                      std::abs(at_high < level ? high : crossing)});
  }
  return reach;
}

} // namespace

double Profile::height(const Plan& plan, double x, double y) const {
  const HeightMap& map = plan.heights;
  // Edges of contact cells may lie outside the map by rounding.
  return map.interpolated(std::clamp(x, map.x.front(), map.x.back()),
                          std::clamp(y, map.y.front(), map.y.back()));
}

double Profile::lowest(const Plan& plan) const {
  return plan.heights.lowest(plan.size);
}

double Profile::lowest_on_slope(const Plan& plan, const std::array<double, 2>& slope) const {
  return plan.heights.lowest(plan.size, slope);
}

std::array<bool, 2> Profile::symmetric(const Plan& plan) const {
  return {plan.heights.symmetric_x(), plan.heights.symmetric_y()};
}

double Profile::border(const Plan& plan, const Pressing& pressing, std::size_t direction) const {
  if (pressing.force > 0) {
    return std::numeric_limits<double>::infinity();
  }
  // Heights are linear along each direction between the grid lines, so that the least height across
  // `direction` lies on a grid line or on the border of the plan.
  const HeightMap& map = plan.heights;
  const double level = lowest(plan) + pressing.indentation;
  const std::vector<double>&along = direction == 0 ? map.x : map.y,
        &across = direction == 0 ? map.y : map.x;
  const double half_across = plan.size[1 - direction] / 2;
  std::vector<double> lines{std::max(-half_across, across.front()),
                            std::min(half_across, across.back())};
  std::ranges::copy_if(across, std::back_inserter(lines),
                       [&](double line) { return std::abs(line) < half_across; });
  double reach = 0;
  std::vector<double> heights(along.size());
  for (const double line : lines) {
    std::ranges::transform(along, heights.begin(), [&](double at) {
      return direction == 0 ? map.interpolated(at, line) : map.interpolated(line, at);
    });
    reach = std::max(reach, reach_below(along, heights, level, plan.size[direction] / 2));
  }
  return reach;
}

std::vector<Misfit> Profile::misfits(const Plan& plan) const {
  const HeightMap& map = plan.heights;
  const auto covers = [](const std::vector<double>& lines, double size) {
    const double least = size / 2 * (1 - 1e-9);
    return lines.front() <= -least && lines.back() >= least;
  };
  if (covers(map.x, plan.size[0]) && covers(map.y, plan.size[1])) {
    return {};
  }
  return {{fmt::format("the height map reaches from {:.6g} mm to {:.6g} mm along x and from {:.6g} "
                       "mm to {:.6g} mm along y, less than slider.size",
                       map.x.front() * 1e3, map.x.back() * 1e3, map.y.front() * 1e3,
                       map.y.back() * 1e3),
           {"profile", "size"},
           "coordinates of the height map count from the slider's centre"}};
}

} // namespace ionskin::shapes
