// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace ionskin::shapes {

/// The underside of a slider on a rectangular grid, linear between its points.
struct HeightMap {
  std::vector<double> x, y;   ///< ascending, from the slider's centre [m]
  std::vector<double> height; ///< [y][x], x fastest [m]; only differences count

  double at(std::size_t column, std::size_t row) const { return height[column + x.size() * row]; }
  /// Bilinear; `at_x` and `at_y` lie within the lines.
  double interpolated(double at_x, double at_y) const;
  /// Least height within a plan of some size about the centre, with a slope added along x and y
  /// [m].
  double lowest(const std::array<double, 2>& size, const std::array<double, 2>& slope = {}) const;
  /// True if height(-x, y) = height(x, y), or height(x, -y) = height(x, y), to rounding.
  bool symmetric_x() const;
  bool symmetric_y() const;
};

} // namespace ionskin::shapes
