// SPDX-License-Identifier: Apache-2.0
#include "ionskin/linear_algebra/fixed_point_columns.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace ionskin::linear_algebra {
namespace {

constexpr std::size_t rows = 1000;

std::vector<double> column(double size) {
  std::vector<double> values(rows);
  for (std::size_t i = 0; i < rows; ++i) {
    values[i] = size * std::sin(0.7 * static_cast<double>(i));
  }
  return values;
}

std::vector<double> kept(const std::vector<double>& values) {
  FixedPointColumns columns(rows, 3);
  columns.set(1, values.data());
  std::vector<double> result(rows, -1);
  columns.get(1, result.data());
  return result;
}

TEST(FixedPointColumns, round_to_a_fraction_of_the_largest_entry) {
  for (const double size : {1e-12, 1.0, 1e9}) {
    const std::vector<double> given = column(size), read = kept(given);
    for (std::size_t i = 0; i < rows; ++i) {
      ASSERT_NEAR(read[i], given[i], 9.2e-13 * size) << i;
    }
  }
}

TEST(FixedPointColumns, keep_the_largest_of_either_sign) {
  std::vector<double> given(rows);
  given[0] = -3e-7;
  given[1] = 3e-7;
  given[2] = -1e-19; // less than half a unit
  const std::vector<double> read = kept(given);
  EXPECT_DOUBLE_EQ(read[0], -3e-7);
  EXPECT_DOUBLE_EQ(read[1], 3e-7);
  EXPECT_EQ(read[2], 0.0);
}

TEST(FixedPointColumns, of_nothing_are_zero) {
  const std::vector<double> nothing(rows);
  EXPECT_EQ(kept(nothing), nothing);
}

TEST(FixedPointColumns, do_not_touch_each_other) {
  FixedPointColumns columns(rows, 3);
  std::vector<std::vector<double>> read(3, std::vector<double>(rows));
  for (std::size_t j = 0; j < 3; ++j) {
    columns.set(j, column(std::pow(10.0, j)).data());
  }
  for (std::size_t j = 0; j < 3; ++j) {
    columns.get(j, read[j].data());
    EXPECT_EQ(read[j], kept(column(std::pow(10.0, j))));
  }
  EXPECT_EQ(columns.rows(), rows);
  EXPECT_EQ(columns.columns(), 3U);
}

} // namespace
} // namespace ionskin::linear_algebra
