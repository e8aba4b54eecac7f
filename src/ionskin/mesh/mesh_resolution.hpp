// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/mesh/footprint.hpp"
#include "ionskin/mesh/grading.hpp"

#include <array>
#include <cstddef>

namespace ionskin::mesh {

/// Element sizes and element counts of the mesh of one case, made by `mesh_resolution`.
/// `numerics.mesh_refinement` r divides the sizes, multiplies the counts and takes the r-th root of
/// the growth factors, so that meshes of different r belong to one family and converge together.
struct MeshResolution {
  /// Element size at sharp edges of the slider, or throughout the rim of another contact, along x
  /// and y [m].
  std::array<double, 2> edge_size{};
  double footprint_growth = 0; ///< ratio of successive sizes, from edges or rim inwards [1]
  std::array<double, 2> footprint_largest{}; ///< largest size in the footprint, along x and y [m]
  std::array<EdgeZone, 2> edge_zone{};       ///< zone inside sharp edges, along x and y
  double outer_growth = 0; ///< largest ratio of successive sizes outside the footprint [1]
  /// Least number of elements before the footprint along the slide, and of elements behind it.
  std::size_t outer_minimum = 0;
  std::size_t face_elements = 0; ///< in the layer at a free end or side of the skin
  std::size_t core_elements = 0; ///< through the thickness of the core; even
  double core_growth = 0; ///< ratio of successive sizes from both interfaces to the middle [1]
  std::size_t electrode_elements = 0; ///< through the thickness of each electrode
  /// Ratio of successive sizes from the top face downwards, in skins thicker than the footprint's
  /// smaller side [1].
  double depth_growth = 0;
};

/// Resolution of the mesh of a case. Sizes at sharp edges are proportional to the smaller of the
/// skin's thickness and a quarter of the footprint's smaller side, because the strain varies over
/// these lengths there. In the rim of a round contact sizes are fractions of the rim's width, and
/// so are the largest sizes where such a contact ends at a sharp edge, too. In the rim around a
/// flat part they are no smaller than at a sharp edge; a narrower rim is then not distinguished
/// from a sharp edge.
MeshResolution mesh_resolution(const Case& input, const Footprint& footprint);

/// Number of elements through the thickness of the core. It is even, so that no element lies across
/// the middle, where the shear changes its sign.
std::size_t core_elements(const Numerics& numerics);

} // namespace ionskin::mesh
