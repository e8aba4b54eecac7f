// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>
#include <vector>

namespace ionskin::live {

/// Lines of a table on both sides of 0.
inline constexpr std::size_t slopes_on_a_side = 6;

/// Lines of a table up to the steepest slope: points of Chebyshev on each side, both ends and 0
/// among them.
std::vector<double> slope_lines(double steepest);

/// True if lines are those of a table.
bool is_table_of_slopes(std::span<const double> lines);

/// Value at slopes along x and y within the lines, by a polynomial in each quadrant: the lowest
/// point of an underside goes from edge to edge where a slope changes its sign.
/// @param values [slope along y][along x]
double at_slope(std::span<const double> lines, std::span<const double> values,
                const std::array<double, 2>& slope) noexcept;

} // namespace ionskin::live
