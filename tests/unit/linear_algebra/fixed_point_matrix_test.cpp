// SPDX-License-Identifier: Apache-2.0
#include "ionskin/linear_algebra/fixed_point_matrix.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace ionskin::linear_algebra {
namespace {

/// More rows than one block, columns of very different size, one of them zero.
DenseMatrix example() {
  DenseMatrix matrix(700, 5);
  for (int j = 0; j < 4; ++j) {
    for (int i = 0; i < matrix.rows; ++i) {
      matrix(i, j) = std::pow(1e-3, j) * std::sin(0.7 * i + j);
    }
  }
  return matrix;
}

FixedPointMatrix fixed(const DenseMatrix& matrix) {
  FixedPointMatrix result(matrix.rows, matrix.columns);
  for (int j = 0; j < matrix.columns; ++j) {
    result.set_column(j, matrix.column(j));
  }
  return result;
}

TEST(FixedPointMatrix, rounds_to_a_fraction_of_the_largest_entry_of_the_column) {
  const DenseMatrix matrix = example();
  const FixedPointMatrix rounded = fixed(matrix);
  for (int j = 0; j < matrix.columns; ++j) {
    for (int i = 0; i < matrix.rows; ++i) {
      EXPECT_NEAR(rounded(i, j), matrix(i, j), 2.4e-10 * std::pow(1e-3, j));
    }
  }
  EXPECT_EQ(rounded(3, 4), 0.0);
}

TEST(FixedPointMatrix, product_is_that_of_the_rounded_entries) {
  const FixedPointMatrix rounded = fixed(example());
  DenseMatrix right(5, 3);
  for (int k = 0; k < 3; ++k) {
    for (int j = 0; j < 5; ++j) {
      right(j, k) = std::pow(1e3, j) * std::cos(j + 2.0 * k);
    }
  }
  DenseMatrix product(700, 3);
  multiply_add(rounded, right, product);
  for (int k = 0; k < 3; ++k) {
    for (int i = 0; i < 700; ++i) {
      double expected = 0;
      for (int j = 0; j < 5; ++j) {
        expected += rounded(i, j) * right(j, k);
      }
      EXPECT_NEAR(product(i, k), expected, 1e-14);
    }
  }
}

TEST(FixedPointMatrix, a_column_of_a_product_is_the_same_bits_in_any_company) {
  const FixedPointMatrix rounded = fixed(example());
  DenseMatrix right(5, 11);
  for (std::size_t i = 0; i < right.values.size(); ++i) {
    right.values[i] = std::cos(1.7 * static_cast<double>(i));
  }
  DenseMatrix together(700, 11);
  multiply_add(rounded, right, together);
  for (int k = 0; k < right.columns; ++k) {
    DenseMatrix column(5, 1), alone(700, 1);
    std::copy_n(right.column(k), 5, column.column(0));
    multiply_add(rounded, column, alone);
    EXPECT_TRUE(std::equal(alone.values.begin(), alone.values.end(), together.column(k)));
  }
}

TEST(FixedPointMatrix, rows_without_force_change_no_bit) {
  const FixedPointMatrix rounded = fixed(example());
  DenseMatrix right(5, 2), padded(5, 3);
  for (const int j : {1, 4}) {
    for (int k = 0; k < 2; ++k) {
      right(j, k) = padded(j, k) = std::sin(j + 3.0 * k);
    }
  }
  for (int j = 0; j < 5; ++j) {
    padded(j, 2) = 1; // another column has force everywhere
  }
  DenseMatrix product(700, 2), wider(700, 3), nothing(700, 1);
  multiply_add(rounded, right, product);
  multiply_add(rounded, padded, wider);
  for (int k = 0; k < 2; ++k) {
    EXPECT_TRUE(std::equal(product.column(k), product.column(k) + 700, wider.column(k)));
  }
  multiply_add(rounded, DenseMatrix(5, 1), nothing);
  EXPECT_EQ(nothing.values, std::vector<double>(700, 0.0));
}

} // namespace
} // namespace ionskin::linear_algebra
