// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/finite_layers/plane/grid_fourier.hpp"
#include "ionskin/finite_layers/plane/plane_compliance.hpp"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace ionskin::finite_layers {

/// Forces on the cells of a grid [N], or mean displacements of the cells [m]: normal (downwards),
/// x, y, each [column, row].
using CellFields = std::array<Eigen::MatrixXd, 3>;

/// True if all columns of a grid are equally wide, and all rows equally high, but for rounding.
bool is_even(const ContactGrid& grid);

/// Product of the compliance matrix of `plane_compliance` with forces on a grid of equally large
/// cells, without forming the matrix. The compliance between two cells depends only on their
/// distance, and between a cell and a mirror image only on the distance to the image, so that the
/// products are convolutions by fast Fourier transforms.
class CellConvolution {
public:
  /// Makes an empty convolution, to which `include` adds compliances.
  /// @param grid of equally large cells, see `is_even`
  explicit CellConvolution(const ContactGrid& grid);

  /// Adds the compliance of one body, such as the skin or a soft slider.
  /// @param images whose forces act on the cells, as `plane_compliance` takes them
  /// @param mixed factor on the compliance between normal and tangential components [1]
  void include(const PlaneCompliance& body, const std::vector<RowImage>& images, double mixed = 1);

  /// Adds the displacements that forces cause.
  /// @param forces on the cells [N]
  /// @param displacements to which the result is added [m]
  void add(const CellFields& forces, CellFields& displacements) const;
  /// Columns of the grid of cells.
  Eigen::Index columns() const { return grid_.columns(); }
  /// Rows of the grid of cells.
  Eigen::Index rows() const { return grid_.rows(); }
  /// Compliance of each cell against its own force, without mirrored images: normal, x, y [m/N].
  const std::array<double, 3>& own() const { return own_; }

private:
  /// Transformed compliances of the pairs of components normal-normal, normal-x, normal-y, x-x,
  /// x-y, y-y.
  using Kernel = std::array<GridFourier::Spectrum, 6>;
  GridFourier::Spectrum mirrored(const GridFourier::Spectrum& of_forces) const;
  static void add_product(const Kernel& kernel, const std::array<GridFourier::Spectrum, 3>& forces,
                          std::array<GridFourier::Spectrum, 3>& sum);

  ContactGrid grid_;
  GridFourier fourier_;
  Kernel direct_, mirrored_; ///< `mirrored_` is empty where no image is mirrored
  std::array<double, 3> own_{};
};

} // namespace ionskin::finite_layers
