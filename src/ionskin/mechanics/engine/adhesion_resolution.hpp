// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/case/slider_motion.hpp"
#include "ionskin/mechanics/skin/skin_model.hpp"

#include <string>
#include <vector>

namespace ionskin::mechanics {

/// The cells must resolve the border over which adhesion lets go, docs/model.md (40): judged in the
/// middle of the places `box`. Warns where they hardly do; throws SolverError where they do not.
/// Does nothing under a friction law that does not pull.
void require_resolved_adhesion(const Case& input, const SkinModel& model, const MotionBox& box,
                               std::vector<std::string>& warnings);

} // namespace ionskin::mechanics
