// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/case/slider_motion.hpp"
#include "ionskin/mesh/footprint.hpp"

#include <array>
#include <functional>

namespace ionskin::mechanics {

/// Distance of a footprint from the ends and from the sides of the skin, at least 0 [m].
/// @param places where its centre may be [m]
std::array<double, 2> clearance(const Skin& skin, const mesh::Footprint& footprint,
                                const MotionBox& places);

/// Reach of the skin's short waves then, see finite_layers::skin_resolution: the nearer a face, the
/// more modes it takes [m].
double short_wave_reach(const Skin& skin, const mesh::Footprint& footprint,
                        const MotionBox& places);

/// Multiplications in a step of the contact with the slider's centre at x [m], for the waves along
/// the ends: at every place along the skin they are solved for the cells anew, the more of them the
/// nearer an end (finite_layers::FreeEnds::Rows::add).
/// @param forces on the cells, three each
/// @param half whether they are those of one half of a symmetric contact
std::function<double(double x)> end_products(const Skin& skin, const mesh::Footprint& footprint,
                                             const MotionBox& places, double forces, bool half);

/// Distance to the edges up to which a swing of a slider on a drive is expected, which need not
/// come: nearer, the modes of the skin would take more than some 1 GB. A run tells where it came
/// nearer [m].
double clearance_of_swings(const Skin& skin);

} // namespace ionskin::mechanics
