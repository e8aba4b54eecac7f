// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/finite_layers/fields/plane_waves.hpp"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <vector>

namespace ionskin::finite_layers {

/// Strains under forces on rows of cells, at places along y, for each mode along x: the sums of
/// docs/model.md (59) over the modes along y. They serve all states whose rows and places along y
/// lie in the box alike.
class RowStrains {
public:
  /// @param rows means of the modes along y over the rows of cells, [row, n]
  /// @param along_y means over the places, [place, n]
  RowStrains(const PlaneWaves& waves, const DepthTable& table, const FieldComponents& components,
             const ModeTransform& rows, const ModeTransform& along_y, int threads);

  /// Strains of states at the places along y of a block of modes along x,
  /// [mode, place + count of places * component].
  void at(std::size_t level, Eigen::Index first_m, const std::vector<WaveLoads>& loads,
          std::vector<ByKind>& rows) const;

private:
  Eigen::Index rows_;
  std::array<Eigen::Index, 2> values_; ///< places times components of each kind
  /// Matrix of each level, [place and component, row and force component and mode along x].
  std::vector<Eigen::MatrixXd> of_level_;
};

} // namespace ionskin::finite_layers
