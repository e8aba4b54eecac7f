// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/finite_layers/fields/plane_waves.hpp"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <vector>

namespace ionskin::finite_layers {

/// Strains at places along y per force on rows of cells, for each mode along x: the sums of
/// docs/model.md (59) over the modes along y. They serve all states whose rows and places have the
/// same positions along y.
class RowStrains {
public:
  /// Calculates the sums for all levels of the table.
  /// @param rows means of the modes along y over the rows of cells, [row, n]
  /// @param along_y means of the modes along y over the places, [place, n]
  /// @param threads number of threads to use
  RowStrains(const PlaneWaves& waves, const DepthTable& table, const FieldComponents& components,
             const ModeTransform& rows, const ModeTransform& along_y, int threads);

  /// Calculates the strains of states at one level for a block of modes along x.
  /// @param first_m first mode along x of the block
  /// @param loads forces on the cells, one entry per state
  /// @param rows result with one entry per state, [mode of the block, place + number of places *
  /// component] for each kind of components [1]
  void at(std::size_t level, Eigen::Index first_m, const std::vector<WaveLoads>& loads,
          std::vector<ByKind>& rows) const;

private:
  Eigen::Index rows_;
  /// Number of places times components, for each kind of components.
  std::array<Eigen::Index, 2> values_;
  /// Matrix of each level, [place and component, (mode along x, force component, row)] [1/N].
  std::vector<Eigen::MatrixXd> of_level_;
};

} // namespace ionskin::finite_layers
