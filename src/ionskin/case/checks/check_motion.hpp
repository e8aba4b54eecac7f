// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/document/case_document.hpp"

namespace ionskin {

/// Checks that the keys of the motion belong to its kind, and that waypoints make a path: at least
/// two, from 0 s on and ascending in time, each with either a height or a force, above the rigid
/// base, detached at the start, and closed if there are several cycles.
/// @param problems collects mistakes
/// @return true if the motion has valid legs, which other checks need
bool check_motion(const CaseDocument& document, Problems& problems);

/// Finds the position of a waypoint in the case or in its waypoint file, for an error message.
/// @param index of the waypoint, from 0
/// @param note printed at the position
std::vector<Pointer> point_at_waypoint(const CaseDocument& document, std::size_t index,
                                       const std::string& note = "");

} // namespace ionskin
