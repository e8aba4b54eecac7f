// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

namespace ionskin::finite_layers {

/// Discrete Fourier transforms of fields on an even grid of cells, on a grid at least twice as long
/// and wide, so that products of transforms are convolutions that do not wrap around.
class GridFourier {
public:
  GridFourier(Eigen::Index columns, Eigen::Index rows);

  Eigen::Index columns() const { return columns_; } ///< of the larger grid
  Eigen::Index rows() const { return rows_; }

  /// [wave along y, wave along x], of the second those up to half of the columns.
  using Spectrum = Eigen::ArrayXXcd;
  /// Transform of a field that fills the first columns and rows.
  /// @param field [column, row], of the first of them; others are 0
  Spectrum forward(const Eigen::MatrixXd& field) const;
  /// The first columns and rows of a field.
  Eigen::MatrixXd back(const Spectrum& spectrum, Eigen::Index columns, Eigen::Index rows) const;

private:
  Eigen::Index columns_, rows_;
};

} // namespace ionskin::finite_layers
