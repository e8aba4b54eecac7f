// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/finite_layers/plane/box_modes.hpp"
#include "ionskin/finite_layers/plane/cell_convolution.hpp"
#include "ionskin/finite_layers/skin/layer_box.hpp"

#include <Eigen/Core>

#include <array>
#include <memory>

namespace ionskin::finite_layers {

/// Share of the modes that the ends of a skin feel of a slider at a place.
struct NearEnds {
  Eigen::ArrayXd share; ///< of the first modes along x
  double last = 0;      ///< wave number along the ends that counts in full [1/m]
};

/// Displacement of cells that the long waves of a skin add by the forces on them, with its
/// sides and ends: products with the second part of its compliance, docs/model.md (54), (56), (57),
/// by the modes of the columns and of the rows, without its matrix.
class LongWaves {
public:
  /// @param centre of the slider [m]
  LongWaves(std::shared_ptr<const LayerBox> box, const ContactGrid& grid,
            const std::array<double, 2>& centre, NearEnds near);

  /// Adds the displacements by forces.
  void add(const CellFields& forces, CellFields& displacements) const;
  /// Adds those of the cells of another slider on the same skin.
  void add_at(const LongWaves& other, const CellFields& forces, CellFields& displacements) const;
  /// About that of a cell by its own force: normal, x, y [m/N].
  std::array<double, 3> own() const;

private:
  /// [mode along x, along y], normal, x, y.
  using Modes = std::array<Eigen::MatrixXd, 3>;
  Modes displaced(const Modes& forces) const;

  std::shared_ptr<const LayerBox> box_;
  NearEnds near_;
  double images_;
  std::array<Eigen::MatrixXd, 3> rows_; ///< waves of each component over the rows, [row, n]
  /// Over the columns, those of the modes and those a quarter of a wave beside them, [column, m].
  std::array<Eigen::MatrixXd, 3> columns_, beside_;
  /// Share of both in what modes along x do: alike at all places, and mirrored at the ends.
  Eigen::ArrayXd weight_, weight_beside_;
};

} // namespace ionskin::finite_layers
