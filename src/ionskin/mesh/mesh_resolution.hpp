// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/mesh/footprint.hpp"
#include "ionskin/mesh/grading.hpp"

#include <array>
#include <cstddef>

namespace ionskin::mesh {

/// Element sizes and counts of one case. `numerics.mesh_refinement` divides the sizes, multiplies
/// the counts and takes the matching root of the growth factors, so that refined meshes are of one
/// family.
struct MeshResolution {
  /// At the slider's edges, or throughout the rim of a round contact, along x and y [m].
  std::array<double, 2> edge_size{};
  double footprint_growth = 0;               ///< from the edges or the rim inwards [1]
  std::array<double, 2> footprint_largest{}; ///< along x and y [m]
  std::array<EdgeZone, 2> edge_zone{};       ///< inside sharp edges, along x and y [m]
  double outer_growth = 0;                   ///< largest admitted away from footprint and faces [1]
  std::size_t outer_minimum = 0;             ///< before and behind the footprint along the slide
  std::size_t face_elements = 0;             ///< in the edge layer of a free face close by
  std::size_t core_elements = 0;             ///< through the thickness of the core; even
  double core_growth = 0;                    ///< from both interfaces to the middle [1]
  std::size_t electrode_elements = 0;        ///< through each electrode layer
  double depth_growth = 0; ///< from the top downwards in skins that are thick for the footprint [1]
};

/// Sizes at sharp edges scale with the smaller of the skin's thickness and a quarter of the
/// footprint's smaller side: the lengths over which the strain varies there. In the rim of a round
/// contact they are parts of its width; in a rim around a flat part they are no smaller than at a
/// sharp edge, from which a narrower rim can then not be distinguished.
MeshResolution mesh_resolution(const Case& input, const Footprint& footprint);

/// Number of elements through the thickness of the core; even.
std::size_t core_elements(const Numerics& numerics);

} // namespace ionskin::mesh
