// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/mechanics/path/shared_progress.hpp"
#include "ionskin/mechanics/solve_contact.hpp"

#include <cstddef>
#include <vector>

namespace ionskin::mechanics {

/// Whether a motion is stepped on interpolated compliances, or solved leg by leg. Legs are exact
/// for straight strokes between two places, which share the positions of their ends; a path of
/// waypoints has any number of legs, of any length and direction, friction that depends on
/// slip, speed or direction has no steady sliding that its legs could begin from, and a slider on a
/// drive leaves the path.
bool is_stepped(const Case& input);

/// Positions that a stepped motion is expected to need; 0 when it never touches.
std::size_t expected_positions(const Case& input);

/// All of Study 1 for a motion that is stepped, one solution per variant, which share their
/// positions. `options.surface_before` is not used: a path begins on an unloaded skin.
std::vector<ContactSolution> solve_stepped(const Case& input, const mesh::Footprint& footprint,
                                           const std::vector<ContactVariant>& variants,
                                           const ContactOptions& options, base::Timers& timers,
                                           SharedProgress& progress);

} // namespace ionskin::mechanics
