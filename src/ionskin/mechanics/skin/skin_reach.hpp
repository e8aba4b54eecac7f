// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/case/slider_motion.hpp"
#include "ionskin/mesh/footprint.hpp"

#include <array>

namespace ionskin::mechanics {

/// Distance of a footprint from the ends and from the sides of the skin, at least 0 [m].
/// @param places where its centre may be [m]
std::array<double, 2> clearance(const Skin& skin, const mesh::Footprint& footprint,
                                const MotionBox& places);

/// Reach of the skin's short waves then, see finite_layers::skin_resolution: the nearer a face, the
/// more modes it takes [m].
double short_wave_reach(const Skin& skin, const mesh::Footprint& footprint,
                        const MotionBox& places);

} // namespace ionskin::mechanics
