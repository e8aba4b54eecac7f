// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/mesh/mesh_resolution.hpp"

#include <cstddef>
#include <vector>

namespace ionskin::mesh {

/// Element lines through the layers.
struct ThicknessLines {
  std::vector<double> z;                 ///< ascending from the bottom of the lowest layer [m]
  std::vector<std::size_t> layer_of_row; ///< per element row
};

/// A fixed count per layer in skins that are thin against the footprint. Where the skin is thicker
/// than the footprint's smaller side, the strain varies with the depth under the contact instead,
/// and elements grow downwards from the size of the footprint's.
ThicknessLines thickness_lines(const Skin& skin, const Footprint& footprint,
                               const MeshResolution& resolution);

} // namespace ionskin::mesh
