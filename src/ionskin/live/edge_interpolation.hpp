// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace ionskin::live {

/// Linear interpolation at a coordinate: indices of the two edges around it, and their weights,
/// which add up to 1. Outside all edges, both are the nearest edge, with the weights 1 and 0.
struct Between {
  std::array<std::size_t, 2> edge{};
  std::array<double, 2> weight{};
};

/// Finds the edges around a coordinate and their weights.
/// @param edges ascending, not empty
/// @param at coordinate, in the unit of the edges
inline Between between(const std::vector<double>& edges, double at) noexcept {
  const auto above = std::ranges::upper_bound(edges, at);
  if (above == edges.begin() || above == edges.end()) {
    const std::size_t end = above == edges.begin() ? 0 : edges.size() - 1;
    return {{end, end}, {1, 0}};
  }
  const auto i = static_cast<std::size_t>(above - edges.begin());
  const double weight = (at - edges[i - 1]) / (edges[i] - edges[i - 1]);
  return {{i - 1, i}, {1 - weight, weight}};
}

/// Finds the edges around a coordinate and the derivatives of their weights by the coordinate; 0
/// outside the edges. On an edge, the derivatives are taken in the interval above it.
inline Between slope_between(const std::vector<double>& edges, double at) noexcept {
  Between result = between(edges, at);
  const auto& [low, high] = result.edge;
  const double slope = low == high ? 0.0 : 1 / (edges[high] - edges[low]);
  result.weight = {-slope, slope};
  return result;
}

} // namespace ionskin::live
