// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"

#include <cstddef>

namespace ionskin::mesh {

/// Element sizes and counts of one case. `numerics.mesh_refinement` divides the sizes, multiplies
/// the counts and takes the matching root of the growth factors, so that refined meshes are of one
/// family.
struct MeshResolution {
  double edge_size = 0;               ///< at the slider's edges [m]
  double footprint_growth = 0;        ///< from the edges inwards [1]
  double footprint_largest = 0;       ///< [m]
  double outer_growth = 0;            ///< largest admitted away from the footprint [1]
  std::size_t outer_minimum = 0;      ///< before and behind the footprint along the slide
  std::size_t core_elements = 0;      ///< through the thickness of the core
  double core_growth = 0;             ///< from both interfaces to the middle [1]
  std::size_t electrode_elements = 0; ///< through each electrode layer
};

/// Sizes scale with the smaller of the skin's thickness and a quarter of the slider's smaller side:
/// the lengths over which the strain varies around the edges.
MeshResolution mesh_resolution(const Case& input);

} // namespace ionskin::mesh
