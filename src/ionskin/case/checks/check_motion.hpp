// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/document/case_document.hpp"

namespace ionskin {

/// Checks that the keys of the motion belong to its kind, and that waypoints make a path: at least
/// two, from 0 s on and ascending in time, each with either a height or a force, detached at the
/// beginning, closed when there are several cycles, inside the skin.
/// @return whether the motion makes sense, so that others may look at its legs
bool check_motion(const CaseDocument& document, Problems& problems);

/// Where a waypoint stands in its case or file, with a note.
std::vector<Pointer> point_at_waypoint(const CaseDocument& document, std::size_t index,
                                       const std::string& note = "");

} // namespace ionskin
