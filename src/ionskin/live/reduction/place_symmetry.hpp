// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/slider_motion.hpp"
#include "ionskin/live/reduction/place_nodes.hpp"
#include "ionskin/live/reduction/reflections.hpp"
#include "ionskin/live/skin_data.hpp"
#include "ionskin/mechanics/skin/skin_model.hpp"

namespace ionskin::live {

/// Reflections that leave the slider as it is; the skin has both.
Reflections reflections_of(const mechanics::SkinModel& model);

/// True if the mirror image of every node on the skin is a node.
bool are_mirrored(const PlaceNodes& places, const SkinData& data);

/// A box of places that is its own mirror image on the skin.
MotionBox mirrored_box(const MotionBox& box, const SkinData& data);

} // namespace ionskin::live
