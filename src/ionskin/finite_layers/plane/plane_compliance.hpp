// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/finite_layers/plane/half_space_cells.hpp"
#include "ionskin/finite_layers/plane/radial_compliance.hpp"

#include <Eigen/Core>

#include <vector>

namespace ionskin::finite_layers {

/// Rectangles under a slider on each of which the traction is even, from their lines.
struct ContactGrid {
  std::vector<double> x, y; ///< lines from the slider's centre, ascending [m]
  /// True if these are the rows of y < 0, and each cell stands for its mirror image too, which
  /// carries the mirrored force.
  bool half = false;

  Eigen::Index columns() const { return static_cast<Eigen::Index>(x.size()) - 1; }
  Eigen::Index rows() const { return static_cast<Eigen::Index>(y.size()) - 1; }
  Eigen::Index count() const { return columns() * rows(); }
  Interval column(Eigen::Index i) const;
  Interval row(Eigen::Index j) const;
};

/// Mean displacement of a cell over the force on another, both normal (downwards), x, y [m/N].
using CellCompliance = Eigen::Matrix3d;

/// Compliance of short waves in an unbounded skin: where the slider is makes no difference.
/// @param x_at,y_at cell that is displaced
/// @param x_from,y_from cell that carries the force
CellCompliance plane_compliance(const PlaneCompliance& skin, const Interval& x_at,
                                const Interval& y_at, const Interval& x_from,
                                const Interval& y_from);

/// An image of all rows of a grid: mirrored, so that y becomes -y, and moved.
struct RowImage {
  bool mirrored = false;
  double shift = 0; ///< along y [m]
};

/// Compliance of the images of all cells on all cells, [3 cell + component], cells with x fastest.
/// Sums over images of which each is its own inverse, or comes with it.
Eigen::MatrixXd plane_compliance(const PlaneCompliance& skin, const ContactGrid& grid,
                                 const std::vector<RowImage>& images);

/// A grid itself, and in a half grid its mirror image.
std::vector<RowImage> own_images(const ContactGrid& grid);
/// The images beside these within a reach that two mirrors make, at y = low and y = high.
std::vector<RowImage> images_between(const ContactGrid& grid, double low, double high,
                                     double reach);

} // namespace ionskin::finite_layers
