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
  /// Whether these are the rows of y < 0, and each cell stands for its mirror image too, which
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

/// Of short waves in an unbounded skin: where the slider is makes no difference.
/// @param x_at,y_at cell that is displaced
/// @param x_from,y_from cell that carries the force
CellCompliance short_wave_compliance(const ShortWaveCompliance& skin, const Interval& x_at,
                                     const Interval& y_at, const Interval& x_from,
                                     const Interval& y_from);

/// Of all cells on all, [3 cell + component], cells with x fastest.
Eigen::MatrixXd short_wave_compliance(const ShortWaveCompliance& skin, const ContactGrid& grid);

} // namespace ionskin::finite_layers
