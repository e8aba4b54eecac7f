// SPDX-License-Identifier: Apache-2.0
#include "ionskin/linear_algebra/fixed_point_matrix.hpp"

#include "ionskin/linear_algebra/dense_kernels.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ionskin::linear_algebra {
namespace {

/// Rows expanded to double precision at a time: a block stays in the cache of one core.
constexpr int block_rows = 128;

std::size_t place(int rows, int i, int j) {
  return static_cast<std::size_t>(rows) * static_cast<std::size_t>(j) + static_cast<std::size_t>(i);
}

} // namespace

FixedPointMatrix::FixedPointMatrix(int row_count, int column_count)
    : rows(row_count), columns(column_count), unit(static_cast<std::size_t>(column_count)),
      values(place(row_count, 0, column_count)) {}

void FixedPointMatrix::set_column(int j, const double* column) {
  double largest = 0;
  for (int i = 0; i < rows; ++i) {
    largest = std::max(largest, std::abs(column[i]));
  }
  constexpr double steps = std::numeric_limits<std::int32_t>::max();
  unit[j] = largest / steps;
  const double scale = largest > 0 ? steps / largest : 0;
  std::int32_t* to = values.data() + place(rows, 0, j);
  for (int i = 0; i < rows; ++i) {
    to[i] = static_cast<std::int32_t>(std::lrint(column[i] * scale));
  }
}

double FixedPointMatrix::operator()(int i, int j) const {
  return unit[j] * values[place(rows, i, j)];
}

DenseMatrix multiply(const FixedPointMatrix& a, const DenseMatrix& b) {
  const KernelThreads one(1);
  DenseMatrix result(a.rows, b.columns), scaled = b, block(std::min(block_rows, a.rows), a.columns);
  for (int k = 0; k < b.columns; ++k) {
    for (int j = 0; j < a.columns; ++j) {
      scaled(j, k) *= a.unit[j];
    }
  }
  for (int first = 0; first < a.rows; first += block_rows) {
    const int count = std::min(block_rows, a.rows - first);
    for (int j = 0; j < a.columns; ++j) {
      const std::int32_t* from = a.values.data() + place(a.rows, first, j);
      std::copy(from, from + count, block.column(j));
    }
    product(false, count, b.columns, a.columns, 1.0, block.values.data(), block.rows,
            scaled.values.data(), scaled.rows, 0.0, result.values.data() + first, result.rows);
  }
  return result;
}

} // namespace ionskin::linear_algebra
