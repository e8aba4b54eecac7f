// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/case/slider_motion.hpp"
#include "ionskin/mesh/footprint.hpp"

#include <array>
#include <functional>

namespace ionskin::mechanics {

/// Distance of the footprint from the ends and from the sides of the skin, where it comes nearest
/// to them; at least 0 [m].
/// @param places box in which the slider's centre may be [m]
std::array<double, 2> clearance(const Skin& skin, const mesh::Footprint& footprint,
                                const MotionBox& places);

/// Reaches and numbers of the waves that resolve a skin; see `finite_layers::SkinResolution`.
struct SkinWaves {
  double reach = 0;                       ///< distance at which short waves end [m]
  double ends_reach = 0, sides_reach = 0; ///< over which motions of the free faces are felt [m]
  double along_ends = 0, along_sides = 0; ///< numbers of waves along these faces [1]
};
/// Finds how finely a skin is resolved when the slider stays within a box: the nearer the slider
/// comes to a face of the skin, the more waves the skin takes.
/// @param places box in which the slider's centre may be [m]
SkinWaves skin_waves(const Skin& skin, const mesh::Footprint& footprint, const MotionBox& places);

/// Number of nodes through the thickness of the finite elements that free the sides and ends.
double nodes_through_thickness(const Skin& skin);

/// Estimates the number of multiplications that the waves along the ends take in one contact step,
/// as a function of the slider's x [m]. They are solved anew at every position along the skin, and
/// take the more modes the nearer an end is (`finite_layers::FreeEnds::Rows::add`).
/// @param places box in which the slider's centre may be [m]
/// @param forces number of force components on the cells, three for each
/// @param half true if the cells are one half of a symmetric contact
std::function<double(double x)> end_products(const Skin& skin, const mesh::Footprint& footprint,
                                             const MotionBox& places, double forces, bool half);

/// Distance from the edges of the skin up to which the skin is resolved for the swings of a slider
/// on a drive [m]. Such swings need not come, and nearer to an edge the modes of the skin would
/// take more than about 1 GB. A run warns where the slider came nearer.
double clearance_of_swings(const Skin& skin);

} // namespace ionskin::mechanics
