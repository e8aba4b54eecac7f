// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/finite_layers/plane/grid_fourier.hpp"
#include "ionskin/finite_layers/plane/plane_compliance.hpp"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace ionskin::finite_layers {

/// Forces on, or mean displacements of, the cells of a grid: normal, x, y, each [column, row].
using CellFields = std::array<Eigen::MatrixXd, 3>;

/// True if all columns of a grid are equally wide, and all rows, to rounding.
bool is_even(const ContactGrid& grid);

/// Products of `plane_compliance` with forces on an even grid, without its matrix: the compliance
/// of two cells depends on their distance alone, and that of mirrored cells on the distance from
/// where they lie, so that products are convolutions.
class CellConvolution {
public:
  /// @param grid of even cells, see `is_even`
  explicit CellConvolution(const ContactGrid& grid);

  /// Adds the compliance of a body whose images act, as `plane_compliance` has it.
  /// @param mixed factor of what is between normal and tangential components
  void include(const PlaneCompliance& body, const std::vector<RowImage>& images, double mixed = 1);

  /// Adds the displacements by forces.
  void add(const CellFields& forces, CellFields& displacements) const;
  Eigen::Index columns() const { return grid_.columns(); }
  Eigen::Index rows() const { return grid_.rows(); }
  /// Compliance of a cell against its own force, without images: normal, x, y [m/N].
  const std::array<double, 3>& own() const { return own_; }

private:
  /// Between normal and normal, normal and x, normal and y, x and x, x and y, y and y.
  using Kernel = std::array<GridFourier::Spectrum, 6>;
  GridFourier::Spectrum mirrored(const GridFourier::Spectrum& of_forces) const;
  static void add_product(const Kernel& kernel, const std::array<GridFourier::Spectrum, 3>& forces,
                          std::array<GridFourier::Spectrum, 3>& sum);

  ContactGrid grid_;
  GridFourier fourier_;
  Kernel direct_, mirrored_; ///< empty where nothing is mirrored
  std::array<double, 3> own_{};
};

} // namespace ionskin::finite_layers
