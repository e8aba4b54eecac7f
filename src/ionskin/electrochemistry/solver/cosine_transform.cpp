// SPDX-License-Identifier: Apache-2.0
#include "ionskin/electrochemistry/solver/cosine_transform.hpp"

#include <Eigen/Core>
#include <cmath>
#include <numbers>

namespace ionskin::electrochemistry {
namespace {

/// Value of an orthonormal cosine mode in a cell of a row of `cells`.
float cosine(std::size_t mode, std::size_t cell, std::size_t cells) {
  const auto count = static_cast<double>(cells);
  const double norm = std::sqrt((mode == 0 ? 1.0 : 2.0) / count);
  const double angle =
      std::numbers::pi * static_cast<double>(mode) * (static_cast<double>(cell) + 0.5) / count;
  return static_cast<float>(norm * std::cos(angle));
}

double eigenvalue(double coupling, std::size_t mode, std::size_t cells) {
  const double angle = std::numbers::pi * static_cast<double>(mode) / static_cast<double>(cells);
  return coupling * (2.0 - 2.0 * std::cos(angle));
}

/// Matrix of cosine modes, row-major: entry (i, j) holds mode first + stride j in cell i.
std::vector<float> cosine_matrix(std::size_t size, std::size_t first, std::size_t stride,
                                 std::size_t cells) {
  std::vector<float> matrix;
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t j = 0; j < size; ++j) {
      matrix.push_back(cosine(first + stride * j, i, cells));
    }
  }
  return matrix;
}

using RowMatrix = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

Eigen::Map<const RowMatrix> square(const std::vector<float>& entries, Eigen::Index size) {
  return {entries.data(), size, size};
}

} // namespace

CosineTransform::CosineTransform(const ScaledGrid& grid)
    : columns_x_(grid.columns_x), columns_y_(grid.columns_y), even_((grid.columns_x + 1) / 2),
      even_x_(cosine_matrix(even_, 0, 2, columns_x_)),
      odd_x_(cosine_matrix(columns_x_ - even_, 1, 2, columns_x_)),
      modes_y_(cosine_matrix(columns_y_, 0, 1, columns_y_)) {
  for (std::size_t j = 0; j < columns_y_; ++j) {
    for (std::size_t i = 0; i < columns_x_; ++i) {
      const std::size_t mode = i < even_ ? 2 * i : 2 * (i - even_) + 1;
      eigenvalues_.push_back(eigenvalue(grid.coupling_x, mode, columns_x_) +
                             eigenvalue(grid.coupling_y, j, columns_y_));
    }
  }
}

/// Computes sums and differences of cells that mirror each other about the middle of x, in every
/// row.
void CosineTransform::fold(std::span<const double> field, float* folded) const {
  const std::size_t n = columns_x_, even = even_, odd = n - even;
  for (std::size_t row = 0; row < field.size(); row += n) {
    const double* from = field.data() + row;
    float* to = folded + row;
#pragma omp simd
    for (std::size_t i = 0; i < odd; ++i) {
      to[i] = static_cast<float>(from[i] + from[n - 1 - i]);
      to[even + i] = static_cast<float>(from[i] - from[n - 1 - i]);
    }
    if (even > odd) {
      to[odd] = static_cast<float>(from[odd]);
    }
  }
}

void CosineTransform::unfold(const float* folded, std::span<double> field) const {
  const std::size_t n = columns_x_, even = even_, odd = n - even;
  for (std::size_t row = 0; row < field.size(); row += n) {
    const float* from = folded + row;
    double* to = field.data() + row;
#pragma omp simd
    for (std::size_t i = 0; i < odd; ++i) {
      to[i] = from[i] + from[even + i];
      to[n - 1 - i] = from[i] - from[even + i];
    }
    if (even > odd) {
      to[odd] = from[odd];
    }
  }
}

void CosineTransform::forward(std::span<const double> field, std::span<float> modes,
                              std::span<float> scratch) const {
  const auto n = static_cast<Eigen::Index>(columns_x_), even = static_cast<Eigen::Index>(even_),
             height = static_cast<Eigen::Index>(columns_y_);
  const auto rows = static_cast<Eigen::Index>(field.size()) / n;
  fold(field, modes.data());
  const Eigen::Map<const RowMatrix> folded(modes.data(), rows, n);
  Eigen::Map<RowMatrix> along_x(scratch.data(), rows, n);
  along_x.leftCols(even).noalias() = folded.leftCols(even) * square(even_x_, even);
  along_x.rightCols(n - even).noalias() = folded.rightCols(n - even) * square(odd_x_, n - even);
  for (Eigen::Index row = 0; row < rows; row += height) {
    Eigen::Map<RowMatrix>(modes.data() + row * n, height, n).noalias() =
        square(modes_y_, height).transpose() * along_x.middleRows(row, height);
  }
}

void CosineTransform::backward(std::span<float> modes, std::span<double> field,
                               std::span<float> scratch) const {
  const auto n = static_cast<Eigen::Index>(columns_x_), even = static_cast<Eigen::Index>(even_),
             height = static_cast<Eigen::Index>(columns_y_);
  const auto rows = static_cast<Eigen::Index>(field.size()) / n;
  Eigen::Map<RowMatrix> along_x(scratch.data(), rows, n);
  for (Eigen::Index row = 0; row < rows; row += height) {
    const Eigen::Map<const RowMatrix> level(modes.data() + row * n, height, n);
    along_x.middleRows(row, height).noalias() = square(modes_y_, height) * level;
  }
  Eigen::Map<RowMatrix> folded(modes.data(), rows, n);
  folded.leftCols(even).noalias() = along_x.leftCols(even) * square(even_x_, even).transpose();
  folded.rightCols(n - even).noalias() =
      along_x.rightCols(n - even) * square(odd_x_, n - even).transpose();
  unfold(modes.data(), field);
}

} // namespace ionskin::electrochemistry
