// SPDX-License-Identifier: Apache-2.0
#include "ionskin/linear_algebra/lower_triangle.hpp"

#include <algorithm>
#include <cstddef>

namespace ionskin::linear_algebra {

LowerTriangle::LowerTriangle(const DenseMatrix& matrix) : size_(matrix.rows) {
  const auto size = static_cast<std::size_t>(size_);
  values_.reserve(size * (size + 1) / 2);
  for (int j = 0; j < size_; ++j) {
    values_.insert(values_.end(), matrix.column(j) + j, matrix.column(j) + size_);
  }
}

const double* LowerTriangle::column(int j) const {
  const auto before = static_cast<std::size_t>(j);
  return values_.data() + before * static_cast<std::size_t>(size_) - before * (before - 1) / 2;
}

DenseMatrix LowerTriangle::dense() const {
  DenseMatrix result(size_, size_);
  for (int j = 0; j < size_; ++j) {
    std::copy_n(column(j), size_ - j, result.column(j) + j);
  }
  return result;
}

} // namespace ionskin::linear_algebra
