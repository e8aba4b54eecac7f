// SPDX-License-Identifier: Apache-2.0
#include "ionskin/shapes/height_map.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

namespace ionskin::shapes {

namespace {

/// Finds the interval of ascending lines that contains a value, and the value's fraction of the
/// interval.
std::pair<std::size_t, double> locate(const std::vector<double>& lines, double value) {
  const auto above = std::upper_bound(lines.begin() + 1, lines.end() - 1, value);
  const auto index = static_cast<std::size_t>(above - lines.begin()) - 1;
  return {index, (value - lines[index]) / (lines[index + 1] - lines[index])};
}

bool mirrored_lines(const std::vector<double>& lines) {
  for (std::size_t i = 0; i < lines.size(); ++i)
    if (std::abs(lines[i] + lines[lines.size() - 1 - i]) > 1e-9 * lines.back())
      return false;
  return true;
}

} // namespace

double HeightMap::interpolated(double at_x, double at_y) const {
  const auto [i, s] = locate(x, at_x);
  const auto [j, t] = locate(y, at_y);
  return (1 - t) * ((1 - s) * at(i, j) + s * at(i + 1, j)) +
         t * ((1 - s) * at(i, j + 1) + s * at(i + 1, j + 1));
}

double HeightMap::lowest(const std::array<double, 2>& size,
                         const std::array<double, 2>& slope) const {
  // The least value is at a grid point within the plan, or where a grid line meets its border.
  const auto places = [](const std::vector<double>& lines, double half) {
    std::vector<double> inside{std::max(-half, lines.front()), std::min(half, lines.back())};
    std::copy_if(lines.begin(), lines.end(), std::back_inserter(inside),
                 [&](double line) { return std::abs(line) < half; });
    return inside;
  };
  double least = std::numeric_limits<double>::infinity();
  for (const double at_y : places(y, size[1] / 2))
    for (const double at_x : places(x, size[0] / 2))
      least = std::min(least, interpolated(at_x, at_y) + (slope[0] * at_x + slope[1] * at_y));
  return least;
}

bool HeightMap::symmetric_x() const {
  const auto [low, high] = std::minmax_element(height.begin(), height.end());
  bool same = mirrored_lines(x);
  for (std::size_t j = 0; j < y.size(); ++j)
    for (std::size_t i = 0; i < x.size(); ++i)
      same = same && std::abs(at(i, j) - at(x.size() - 1 - i, j)) <= 1e-9 * (*high - *low);
  return same;
}

bool HeightMap::symmetric_y() const {
  const auto [low, high] = std::minmax_element(height.begin(), height.end());
  bool same = mirrored_lines(y);
  for (std::size_t j = 0; j < y.size(); ++j)
    for (std::size_t i = 0; i < x.size(); ++i)
      same = same && std::abs(at(i, j) - at(i, y.size() - 1 - j)) <= 1e-9 * (*high - *low);
  return same;
}

} // namespace ionskin::shapes
