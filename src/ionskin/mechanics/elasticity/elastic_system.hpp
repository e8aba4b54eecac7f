// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/mechanics/elasticity/elastic_law.hpp"
#include "ionskin/mechanics/elasticity/elastic_space.hpp"
#include "ionskin/mesh/skin_mesh.hpp"

#include <array>
#include <vector>

namespace ionskin::mechanics {

/// Stiffness of the skin for one position of the mesh lines.
struct ElasticSystem {
  /// Lower triangle in the order of the space's pattern [N/m].
  std::vector<double> stiffness;
  /// Force of the skin on its base per unit of each unknown, summed over the base: three
  /// components, each [unknowns] [N/m].
  std::array<std::vector<double>, 3> base_reaction;
};

/// Assembles by full integration, exact for box elements.
/// @param law_of_row elastic law of each element row along z
ElasticSystem assemble(const ElasticSpace& space, const mesh::MeshLines& lines,
                       const std::vector<ElasticLaw>& law_of_row);

/// Size of an element along x, y, z [m].
std::array<double, 3> element_size(const ElasticSpace& space, const mesh::MeshLines& lines,
                                   std::size_t element);

} // namespace ionskin::mechanics
