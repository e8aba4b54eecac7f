// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/linear_algebra/sparse_matrix.hpp"

#include <vector>

namespace ionskin::linear_algebra {

/// A dense symmetric matrix in half the memory: the columns of its lower triangle, one behind the
/// other.
class LowerTriangle {
public:
  LowerTriangle() = default;
  /// @param matrix what stands above its diagonal is not read
  explicit LowerTriangle(const DenseMatrix& matrix);

  int size() const { return size_; }
  /// Column j from the diagonal down, size() - j values.
  const double* column(int j) const;
  /// With zeros above the diagonal.
  DenseMatrix dense() const;

private:
  int size_ = 0;
  std::vector<double> values_;
};

} // namespace ionskin::linear_algebra
