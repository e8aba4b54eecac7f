// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

namespace ionskin::finite_layers {

/// Discrete Fourier transforms of fields on a grid of equally large cells. Fields are padded with
/// zeros to a grid at least twice as long and wide, so that products of transforms are convolutions
/// that do not wrap around.
class GridFourier {
public:
  /// Chooses the padded sizes.
  /// @param columns,rows of the grid of cells
  GridFourier(Eigen::Index columns, Eigen::Index rows);

  Eigen::Index columns() const { return columns_; } ///< of the padded grid
  Eigen::Index rows() const { return rows_; }       ///< of the padded grid

  /// Transform of a real field, [wave along y, wave along x]. Waves along x end at half the number
  /// of columns, as those above are complex conjugates.
  using Spectrum = Eigen::ArrayXXcd;
  /// Transforms a field forwards.
  /// @param field [column, row], at most as large as the padded grid, whose remainder is 0
  Spectrum forward(const Eigen::MatrixXd& field) const;
  /// Transforms back, and returns the first columns and rows of the field, [column, row].
  Eigen::MatrixXd back(const Spectrum& spectrum, Eigen::Index columns, Eigen::Index rows) const;

private:
  Eigen::Index columns_, rows_;
};

} // namespace ionskin::finite_layers
