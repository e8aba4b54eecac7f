// SPDX-License-Identifier: Apache-2.0
#include "ionskin/linear_algebra/fixed_point_columns.hpp"

#include <algorithm>
#include <cmath>

namespace ionskin::linear_algebra {
namespace {

constexpr std::int64_t largest_multiple = (std::int64_t{1} << 39) - 1, low_values = 256;

} // namespace

FixedPointColumns::FixedPointColumns(std::size_t row_count, std::size_t column_count)
    : rows_(row_count), unit_(column_count), high_(row_count * column_count),
      low_(row_count * column_count) {}

void FixedPointColumns::set(std::size_t j, const double* column) {
  double largest = 0;
  for (std::size_t i = 0; i < rows_; ++i) {
    largest = std::max(largest, std::abs(column[i]));
  }
  constexpr auto steps = static_cast<double>(largest_multiple);
  unit_[j] = largest / steps;
  const double scale = largest > 0 ? steps / largest : 0;
  std::int32_t* high = high_.data() + j * rows_;
  std::uint8_t* low = low_.data() + j * rows_;
  for (std::size_t i = 0; i < rows_; ++i) {
    const std::int64_t multiple = std::llrint(column[i] * scale);
    low[i] = static_cast<std::uint8_t>(multiple & (low_values - 1));
    high[i] = static_cast<std::int32_t>((multiple - low[i]) / low_values);
  }
}

void FixedPointColumns::get(std::size_t j, double* column) const {
  const double unit = unit_[j];
  const std::int32_t* high = high_.data() + j * rows_;
  const std::uint8_t* low = low_.data() + j * rows_;
  for (std::size_t i = 0; i < rows_; ++i) {
    column[i] = unit * (static_cast<double>(low_values) * high[i] + low[i]);
  }
}

} // namespace ionskin::linear_algebra
