// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/case/slider_motion.hpp"
#include "ionskin/mesh/footprint.hpp"

namespace ionskin::mechanics {

/// Box within which the centre of a slider on a drive may move, so that its footprint stays on the
/// skin [m].
MotionBox room_on_skin(const Case& input, const mesh::Footprint& footprint);

/// Box in which the centre of a slider is expected while it touches [m]. A slider on a drive may
/// leave its path by as much as friction stretches the spring, and swing beyond, within
/// `room_on_skin`. The skin is resolved for this box, the finer the nearer it comes to a face.
/// @param touching box of `contact_box`
MotionBox expected_places(const Case& input, const MotionBox& touching,
                          const mesh::Footprint& footprint);

} // namespace ionskin::mechanics
