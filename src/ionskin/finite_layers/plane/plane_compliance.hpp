// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/finite_layers/plane/half_space_cells.hpp"
#include "ionskin/finite_layers/plane/radial_compliance.hpp"

#include <Eigen/Core>

#include <vector>

namespace ionskin::finite_layers {

/// Grid of contact cells: rectangles under a slider, on each of which the traction is uniform.
struct ContactGrid {
  std::vector<double> x, y; ///< grid lines, measured from the slider's centre, ascending [m]
  /// True if the grid holds only the rows of y < 0 of a symmetric contact. Each cell then stands
  /// for its mirror image at y > 0 as well, which carries the mirrored force.
  bool half = false;

  /// Number of columns.
  Eigen::Index columns() const { return static_cast<Eigen::Index>(x.size()) - 1; }
  /// Number of rows.
  Eigen::Index rows() const { return static_cast<Eigen::Index>(y.size()) - 1; }
  /// Number of cells.
  Eigen::Index count() const { return columns() * rows(); }
  /// Extent of a column along x, from the slider's centre [m].
  Interval column(Eigen::Index i) const;
  /// Extent of a row along y, from the slider's centre [m].
  Interval row(Eigen::Index j) const;
};

/// Mean displacement of one cell per force on another; rows and columns: normal (downwards), x, y
/// [m/N].
using CellCompliance = Eigen::Matrix3d;

/// Calculates the compliance between two cells by short waves, in a skin without ends and sides.
/// Only the vector between the cells matters, not the position of the slider.
/// @param skin response over the distance from a point force
/// @param x_at,y_at cell that is displaced [m]
/// @param x_from,y_from cell that carries the force [m]
CellCompliance plane_compliance(const PlaneCompliance& skin, const Interval& x_at,
                                const Interval& y_at, const Interval& x_from,
                                const Interval& y_from);

/// Image of all rows of a grid: mirrored, so that y becomes -y, if so marked, and then shifted.
struct RowImage {
  bool mirrored = false;
  double shift = 0; ///< displacement along y [m]
};

/// Calculates the compliance of the cells under forces that act on images of the cells. The result
/// is symmetric, with cells numbered x fastest, [3 cell + component, 3 cell + component] [m/N].
/// @param images to sum over. For each image, the list must hold its inverse as well, which may be
/// the image itself.
Eigen::MatrixXd plane_compliance(const PlaneCompliance& skin, const ContactGrid& grid,
                                 const std::vector<RowImage>& images);

/// Returns the grid itself as an image and, for a half grid, its mirror image at y > 0.
std::vector<RowImage> own_images(const ContactGrid& grid);
/// Returns the further images of `own_images` in two mirrors at y = low and y = high which lie
/// within a distance of the cells.
/// @param low,high positions of the mirrors, from the slider's centre [m]
/// @param reach largest distance that matters [m]
std::vector<RowImage> images_between(const ContactGrid& grid, double low, double high,
                                     double reach);

} // namespace ionskin::finite_layers
