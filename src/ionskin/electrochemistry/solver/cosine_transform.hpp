// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/electrochemistry/grid/scaled_grid.hpp"

#include <span>
#include <vector>

namespace ionskin::electrochemistry {

/// Orthonormal cosine transform along x and y, level by level, which diagonalises the lateral
/// Laplacian with zero flux through the sides. Single precision inside. Products with small dense
/// matrices, each half the size because cosines are even or odd about the middle of x, are faster
/// here than fast transforms, whose lengths would have to suit the grid.
class CosineTransform {
public:
  explicit CosineTransform(const ScaledGrid& grid);

  /// Eigenvalue of the negative lateral Laplacian per mode, in the order of the modes (even ones of
  /// x before odd ones).
  const std::vector<double>& eigenvalues() const { return eigenvalues_; }

  /// Some levels of a field to their modes. All spans hold as many whole levels.
  void forward(std::span<const double> field, std::span<float> modes,
               std::span<float> scratch) const;

  /// The inverse; changes `modes`.
  void backward(std::span<float> modes, std::span<double> field, std::span<float> scratch) const;

private:
  void fold(std::span<const double> field, float* folded) const;
  void unfold(const float* folded, std::span<double> field) const;

  std::size_t columns_x_, columns_y_, even_; ///< number of even modes of x
  // Square matrices, row-major: entry (i, j) is the value of mode j in cell i.
  std::vector<float> even_x_, odd_x_; ///< on the first half of the cells
  std::vector<float> modes_y_;
  std::vector<double> eigenvalues_;
};

} // namespace ionskin::electrochemistry
