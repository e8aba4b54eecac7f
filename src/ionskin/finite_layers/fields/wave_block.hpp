// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/finite_layers/fields/field_components.hpp"

#include <Eigen/Core>

namespace ionskin::finite_layers {

/// Number of modes along x and along y that are summed at once. The strains of such a block fit the
/// second-level cache of a processor.
inline constexpr Eigen::Index block_x = 96, block_y = 32;
/// One value for each mode along x of a block, at one mode along y.
using BlockColumn = Eigen::Array<double, block_x, 1>;

/// Properties of the modes of a block that have the same number along y.
struct WaveBlock {
  BlockColumn cosine, sine; ///< direction of the wave [1]
  BlockColumn weight;       ///< weight of the mode times its share [1/m2]
  /// Strain per traction in the order of `DepthStrain`, from `DepthTable`; 0 beyond its cutoff
  /// [1/Pa].
  Eigen::Array<double, block_x, 8> depth;

  /// Sets one column of each strain component, [mode along x, column], from forces on the top face
  /// [1].
  /// @param normal,x,y sums over the cells of the force times the mean of the mode, normal
  /// downwards [N]
  void set_strains(const BlockColumn& normal, const BlockColumn& x, const BlockColumn& y,
                   Strains& strains, Eigen::Index column) const;
};

} // namespace ionskin::finite_layers
