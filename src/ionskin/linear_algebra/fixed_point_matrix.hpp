// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/linear_algebra/sparse_matrix.hpp"

#include <cstdint>
#include <vector>

namespace ionskin::linear_algebra {

/// A dense matrix in half the memory of double precision: every entry is a 32-bit multiple of its
/// column's unit. Rounding is 2.3e-10 of the largest magnitude in the column, 250 times finer than
/// single precision there: differences of neighbouring entries keep their digits.
struct FixedPointMatrix {
  int rows = 0, columns = 0;
  std::vector<double> unit;         ///< [columns]
  std::vector<std::int32_t> values; ///< column-major

  FixedPointMatrix() = default;
  FixedPointMatrix(int row_count, int column_count);
  /// @param column [rows]
  void set_column(int j, const double* column);
  double operator()(int i, int j) const;
};

/// C := C + A B in double precision, shapes [rows, columns], [columns, any], [rows, any]. One
/// thread. A column of C is the same bits whatever columns stand beside it, which products of BLAS
/// do not promise, and adding zero columns of B changes none.
void multiply_add(const FixedPointMatrix& a, const DenseMatrix& b, DenseMatrix& c);

} // namespace ionskin::linear_algebra
