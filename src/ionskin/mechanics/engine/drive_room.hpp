// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/case/slider_motion.hpp"
#include "ionskin/mesh/footprint.hpp"

namespace ionskin::mechanics {

/// Within which a slider on a drive may swing: with its footprint on the skin.
MotionBox room_on_skin(const Case& input, const mesh::Footprint& footprint);

} // namespace ionskin::mechanics
