// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/case/slider_motion.hpp"
#include "ionskin/mesh/footprint.hpp"

#include <array>

namespace ionskin::mechanics {

/// How near a footprint comes to the ends and to the sides of the skin, at least 0 [m].
/// @param places where its centre may be [m]
std::array<double, 2> clearance(const Skin& skin, const mesh::Footprint& footprint,
                                const MotionBox& places);

/// How far the skin's short waves reach then, see finite_layers::skin_resolution: the nearer a
/// face, the more modes it takes [m].
double short_wave_reach(const Skin& skin, const mesh::Footprint& footprint,
                        const MotionBox& places);

/// How near to the edges a swing of a slider on a drive is expected, which need not come: nearer,
/// the modes of the skin would take more than some 1 GB. A run tells where it came nearer [m].
double clearance_of_swings(const Skin& skin);

} // namespace ionskin::mechanics
