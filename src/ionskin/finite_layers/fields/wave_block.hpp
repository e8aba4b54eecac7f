// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/finite_layers/fields/field_components.hpp"

#include <Eigen/Core>

namespace ionskin::finite_layers {

/// Modes along x, and along y, that are summed at once: their strains stay in the second cache.
inline constexpr Eigen::Index block_x = 96, block_y = 32;
/// A value of each mode along x of a block, of one mode along y.
using BlockColumn = Eigen::Array<double, block_x, 1>;

/// Modes of a block that have the same number along y.
struct WaveBlock {
  BlockColumn cosine, sine;               ///< direction of the wave
  BlockColumn weight;                     ///< of a mode, with its share [1/m2]
  Eigen::Array<double, block_x, 8> depth; ///< as `DepthTable` gives it, 0 beyond its cutoff [1/Pa]

  /// Sets a column of strains, [mode along x, column], over forces on the top.
  /// @param normal,x,y sums over cells of force and mean of the mode, normal downwards [N]
  void set_strains(const BlockColumn& normal, const BlockColumn& x, const BlockColumn& y,
                   Strains& strains, Eigen::Index column) const;
};

} // namespace ionskin::finite_layers
