// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/finite_layers/plane/box_modes.hpp"
#include "ionskin/finite_layers/plane/cell_convolution.hpp"
#include "ionskin/finite_layers/skin/layer_box.hpp"

#include <Eigen/Core>

#include <array>
#include <memory>

namespace ionskin::finite_layers {

/// Share of the modes that the ends of a skin still feel from a slider at some distance.
struct NearEnds {
  Eigen::ArrayXd share; ///< factor on each of the first modes along x [1]; further ones are 0
  /// Wave number along the ends up to which modes count in full [1/m].
  double last = 0;
};

/// Products of the long-wave share of the compliance with forces on the contact cells, for one
/// position of the slider, docs/model.md (54), (56), (57). Free sides and ends are included. The
/// products go by the modes of the columns and rows, without forming a matrix.
class LongWaves {
public:
  /// Calculates the modes of the columns and rows.
  /// @param centre position of the slider's centre along x and y, from the skin's corner [m]
  /// @param near share of the modes that the ends feel
  LongWaves(std::shared_ptr<const LayerBox> box, const ContactGrid& grid,
            const std::array<double, 2>& centre, NearEnds near);

  /// Adds the mean displacements of the cells that forces on them cause.
  /// @param forces on the cells [N]
  /// @param displacements to which the result is added [m]
  void add(const CellFields& forces, CellFields& displacements) const;
  /// Adds the mean displacements that forces on these cells cause at the cells of another slider on
  /// the same skin.
  /// @param other long waves of the other slider, made of the same `LayerBox`
  /// @param forces on the cells of this slider [N]
  /// @param displacements of the cells of the other slider, to which the result is added [m]
  void add_at(const LongWaves& other, const CellFields& forces, CellFields& displacements) const;
  /// Estimates the compliance of a cell against its own force, from the middle row: normal, x, y
  /// [m/N].
  std::array<double, 3> own() const;

private:
  /// Amplitudes of the modes, [mode along x, mode along y], for each of normal, x, y.
  using Modes = std::array<Eigen::MatrixXd, 3>;
  Modes displaced(const Modes& forces) const;

  std::shared_ptr<const LayerBox> box_;
  NearEnds near_;
  double images_;
  /// Means of the modes along y over the rows, for each component, [row, n] [1].
  std::array<Eigen::MatrixXd, 3> rows_;
  /// Means over the columns, [column, m] [1]: `columns_` of the modes along x, `beside_` of the
  /// same modes shifted by a quarter of a wavelength.
  std::array<Eigen::MatrixXd, 3> columns_, beside_;
  /// Weights of `columns_` and `beside_` in the sum over the modes along x [1/m]. A part of them
  /// does not depend on the position, another is mirrored at the ends and counts with
  /// `NearEnds::share`.
  Eigen::ArrayXd weight_, weight_beside_;
};

} // namespace ionskin::finite_layers
