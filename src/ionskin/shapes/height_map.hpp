// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace ionskin::shapes {

/// Heights of the underside of a slider on a rectangular grid, bilinear between the grid points.
struct HeightMap {
  std::vector<double> x, y;   ///< grid lines, ascending, measured from the slider's centre [m]
  std::vector<double> height; ///< [y][x], x fastest [m]; only height differences matter

  /// Height at the grid point (x[column], y[row]) [m].
  double at(std::size_t column, std::size_t row) const { return height[column + x.size() * row]; }
  /// Height at a position, by bilinear interpolation [m].
  /// @param at_x, at_y position from the slider's centre [m], within the grid lines
  double interpolated(double at_x, double at_y) const;
  /// Least height within a rectangle about the centre, after a plane is added to the heights [m].
  /// @param size of the rectangle along x and y [m]
  /// @param slope of the plane along x and y [1]
  double lowest(const std::array<double, 2>& size, const std::array<double, 2>& slope = {}) const;
  /// True if height(-x, y) = height(x, y) to rounding.
  bool symmetric_x() const;
  /// True if height(x, -y) = height(x, y) to rounding.
  bool symmetric_y() const;
};

} // namespace ionskin::shapes
