// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/case/slider_motion.hpp"
#include "ionskin/mechanics/skin/skin_model.hpp"

#include <string>
#include <vector>

namespace ionskin::mechanics {

/// Checks that the cells resolve the border over which adhesion lets go, docs/model.md (40), with
/// the slider in the middle of `box`. Does nothing under a friction law without adhesion.
/// @param box positions of the slider's centre [m]
/// @param warnings receives a sentence where the cells are too large for a good resolution
/// Throws SolverError where the cells do not resolve the border at all.
void require_resolved_adhesion(const Case& input, const SkinModel& model, const MotionBox& box,
                               std::vector<std::string>& warnings);

} // namespace ionskin::mechanics
