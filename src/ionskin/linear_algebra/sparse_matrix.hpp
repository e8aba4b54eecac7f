// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace ionskin::linear_algebra {

/// Structure of the lower triangle of a symmetric matrix by columns, diagonal included; row indices
/// ascend in each column.
struct SymmetricPattern {
  int size = 0;
  std::vector<int> column_start; ///< [size + 1]
  std::vector<int> row;          ///< [entries]
};

/// Column-major dense matrix.
struct DenseMatrix {
  int rows = 0, columns = 0;
  std::vector<double> values;

  DenseMatrix() = default;
  DenseMatrix(int row_count, int column_count)
      : rows(row_count), columns(column_count),
        values(static_cast<std::size_t>(row_count) * static_cast<std::size_t>(column_count)) {}
  /// Takes another shape; the values are any.
  void reshape(int row_count, int column_count) {
    rows = row_count;
    columns = column_count;
    values.resize(static_cast<std::size_t>(row_count) * static_cast<std::size_t>(column_count));
  }
  double* column(int j) {
    return values.data() + static_cast<std::size_t>(j) * static_cast<std::size_t>(rows);
  }
  const double* column(int j) const {
    return values.data() + static_cast<std::size_t>(j) * static_cast<std::size_t>(rows);
  }
  double& operator()(int i, int j) { return column(j)[i]; }
  double operator()(int i, int j) const { return column(j)[i]; }
};

} // namespace ionskin::linear_algebra
