// SPDX-License-Identifier: Apache-2.0
#include "ionskin/live/reduction/place_nodes.hpp"

#include <cmath>
#include <cstddef>
#include <numbers>

namespace ionskin::live {
namespace {

/// Range of positions, over the length or width of the skin, for which one node is enough, as the
/// compliance hardly changes within it [1].
constexpr double narrow = 1e-5;
/// Numbers of nodes along the only direction of motion, and along each of two.
constexpr std::size_t along_a_line = 7, along_a_side = 5;

/// Chebyshev points of an interval, ends included, ascending; its middle if `count` is 1.
std::vector<double> chebyshev_points(double low, double high, std::size_t count) {
  if (count == 1) {
    return {0.5 * (low + high)};
  }
  std::vector<double> points;
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = std::numbers::pi * static_cast<double>(i) / static_cast<double>(count - 1);
    points.push_back(0.5 * (low + high) - 0.5 * (high - low) * std::cos(angle));
  }
  return points;
}

} // namespace

PlaceNodes place_nodes(const Skin& skin, const MotionBox& box) {
  const bool along_x = box.high[0] - box.low[0] > narrow * skin.length,
             along_y = box.high[1] - box.low[1] > narrow * skin.width;
  const std::size_t most = along_x && along_y ? along_a_side : along_a_line;
  return {chebyshev_points(box.low[0], box.high[0], along_x ? most : 1),
          chebyshev_points(box.low[1], box.high[1], along_y ? most : 1)};
}

} // namespace ionskin::live
