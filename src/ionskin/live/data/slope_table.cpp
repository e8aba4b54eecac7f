// SPDX-License-Identifier: Apache-2.0
#include "ionskin/live/data/slope_table.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace ionskin::live {
namespace {

using Weights = std::array<double, slopes_on_a_side + 1>;

/// Lagrange weights, at a slope, of the lines on one side of the table, 0 included.
/// @param begin index of the first line of the side
Weights weights_at(std::span<const double> lines, std::size_t begin, double slope) noexcept {
  Weights weights{};
  for (std::size_t i = 0; i < weights.size(); ++i) {
    weights[i] = 1;
    for (std::size_t j = 0; j < weights.size(); ++j) {
      if (j != i) {
        weights[i] *= (slope - lines[begin + j]) / (lines[begin + i] - lines[begin + j]);
      }
    }
  }
  return weights;
}

} // namespace

std::vector<double> slope_lines(double steepest) {
  std::vector<double> lines;
  for (std::size_t i = 0; i <= slopes_on_a_side; ++i) {
    const double angle =
        std::numbers::pi * static_cast<double>(i) / static_cast<double>(slopes_on_a_side);
    lines.push_back(-0.5 * steepest * (1 + std::cos(angle)));
  }
  lines.back() = 0;
  for (std::size_t i = slopes_on_a_side; i-- > 0;) {
    lines.push_back(-lines[i]);
  }
  return lines;
}

bool is_table_of_slopes(std::span<const double> lines) {
  return lines.size() == 2 * slopes_on_a_side + 1 && lines[slopes_on_a_side] == 0 &&
         std::ranges::adjacent_find(lines, std::greater_equal{}) == lines.end();
}

double at_slope(std::span<const double> lines, std::span<const double> values,
                const std::array<double, 2>& slope) noexcept {
  const std::size_t begin_x = slope[0] < 0 ? 0 : slopes_on_a_side,
                    begin_y = slope[1] < 0 ? 0 : slopes_on_a_side;
  const Weights x = weights_at(lines, begin_x, slope[0]), y = weights_at(lines, begin_y, slope[1]);
  double value = 0;
  for (std::size_t j = 0; j < y.size(); ++j) {
    for (std::size_t i = 0; i < x.size(); ++i) {
      value += x[i] * y[j] * values[(begin_y + j) * lines.size() + begin_x + i];
    }
  }
  return value;
}

} // namespace ionskin::live
