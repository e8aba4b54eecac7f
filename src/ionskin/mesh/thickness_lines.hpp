// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/mesh/mesh_resolution.hpp"

#include <cstddef>
#include <vector>

namespace ionskin::mesh {

/// Element lines through the thickness of all layers of the skin, made by `thickness_lines`.
struct ThicknessLines {
  std::vector<double> z; ///< lines, ascending from the bottom of the lowest layer [m]
  std::vector<std::size_t> layer_of_row; ///< index of the layer of each element, from the bottom
};

/// Element lines through the thickness of a skin. A skin that is no thicker than the footprint's
/// smaller side has a fixed number of elements in each layer. In a thicker skin the strain varies
/// with the depth under the contact instead, and elements grow downwards from the element size of
/// the footprint.
ThicknessLines thickness_lines(const Skin& skin, const Footprint& footprint,
                               const MeshResolution& resolution);

} // namespace ionskin::mesh
