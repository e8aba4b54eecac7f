// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/slider_motion.hpp"
#include "ionskin/live/data/skin_data.hpp"
#include "ionskin/live/reduction/place_nodes.hpp"
#include "ionskin/live/reduction/reflections.hpp"
#include "ionskin/mechanics/skin/skin_model.hpp"

namespace ionskin::live {

/// Reflections along x and y that map the contact cells and the slider's underside onto themselves.
/// The skin is symmetric under both.
Reflections reflections_of(const mechanics::SkinModel& model);

/// True if the mirror image of every node, about the middle of the skin, is a node.
bool are_mirrored(const PlaceNodes& places, const SkinData& data);

/// Smallest rectangle of positions that contains a given one and is symmetric about the middle of
/// the skin.
MotionBox mirrored_box(const MotionBox& box, const SkinData& data);

} // namespace ionskin::live
