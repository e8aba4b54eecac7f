// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/electrochemistry/grid/scaled_grid.hpp"

#include <span>
#include <vector>

namespace ionskin::electrochemistry {

/// Orthonormal cosine transform of fields along x and y, level by level, which diagonalises the
/// lateral Laplacian with zero flux through the sides. It computes in single precision. Products
/// with small dense matrices, halved because cosines are even or odd about the middle of x, are
/// faster here than fast transforms, whose lengths would have to suit the grid.
class CosineTransform {
public:
  explicit CosineTransform(const ScaledGrid& grid);

  /// Eigenvalues of the negative lateral Laplacian, in the order of the modes [y][x], even modes of
  /// x before odd ones [1/lambda^2].
  const std::vector<double>& eigenvalues() const { return eigenvalues_; }

  /// Transforms some whole levels of a field to their modes. All spans have the same length.
  /// @param modes receives the modes, [level][mode]
  void forward(std::span<const double> field, std::span<float> modes,
               std::span<float> scratch) const;

  /// Transforms modes of some whole levels back to the field; overwrites `modes`. All spans have
  /// the same length.
  void backward(std::span<float> modes, std::span<double> field, std::span<float> scratch) const;

private:
  void fold(std::span<const double> field, float* folded) const;
  void unfold(const float* folded, std::span<double> field) const;

  std::size_t columns_x_, columns_y_, even_; ///< number of even modes of x
  // Square matrices, row-major: entry (i, j) is the value of mode j in cell i.
  std::vector<float> even_x_, odd_x_; ///< on the first half of the cells of x
  std::vector<float> modes_y_;
  std::vector<double> eigenvalues_;
};

} // namespace ionskin::electrochemistry
