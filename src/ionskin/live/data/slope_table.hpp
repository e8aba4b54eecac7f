// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>
#include <vector>

namespace ionskin::live {

/// Number of lines of a slope table on either side of 0.
inline constexpr std::size_t slopes_on_a_side = 6;

/// Slopes at which a table is filled, for use along x and along y: Chebyshev points on either side
/// of 0, with 0 and both ends among them, ascending [1].
/// @param steepest largest slope [1]
std::vector<double> slope_lines(double steepest);

/// True if the slopes are ascending, of the number that `slope_lines` returns, and 0 in the middle.
bool is_table_of_slopes(std::span<const double> lines);

/// Interpolates a table at a slope, by a polynomial in each quadrant of slopes, since the lowest
/// point of an underside jumps from one edge to another where a slope changes sign.
/// @param lines from `slope_lines`
/// @param values [slope along y][slope along x]
/// @param slope along x and y, within the lines [1]
double at_slope(std::span<const double> lines, std::span<const double> values,
                const std::array<double, 2>& slope) noexcept;

} // namespace ionskin::live
