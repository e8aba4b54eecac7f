// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/case/slider_motion.hpp"
#include "ionskin/mesh/footprint.hpp"

namespace ionskin::mechanics {

/// Room within which a slider on a drive may swing: with its footprint on the skin.
MotionBox room_on_skin(const Case& input, const mesh::Footprint& footprint);

/// Places at which the centre of a slider is expected while it touches: of one on a drive by what
/// friction and its mass do to the spring, within its room. It says how near faces of the skin are
/// resolved.
/// @param touching as of `contact_box`
MotionBox expected_places(const Case& input, const MotionBox& touching,
                          const mesh::Footprint& footprint);

} // namespace ionskin::mechanics
