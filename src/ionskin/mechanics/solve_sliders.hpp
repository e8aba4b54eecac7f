// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/mechanics/solve_contact.hpp"

#include <vector>

namespace ionskin::mechanics {

/// Runs Study 1 for several sliders on one skin, docs/model.md (81): each slider presses a skin
/// that the other sliders have displaced. Solves the path of each slider in turn, under the latest
/// forces of the other sliders, and repeats such passes until no force changes by more than the
/// resolution of the paths.
/// @param sliders one case for each slider, identical but for slider, motion and friction, with
///   cycles of one duration
/// @returns one solution for each slider, on half of the skin where all sliders move along its
///   middle
/// Throws UserError before any path is solved, where the cases do not go together or two sliders
/// come nearer to each other than short waves in the skin reach; SolverError where the passes do
/// not converge.
std::vector<ContactSolution> solve_sliders(const std::vector<Case>& sliders,
                                           const ContactOptions& options, base::Timers& timers);

/// Checks, before any contact is solved, that sliders stay farther apart than short waves in the
/// skin reach. The contact of a slider without sharp edges is not known yet, and counts as a point
/// at the slider's centre, so that only sure violations are found.
/// Throws UserError where two sliders come too near to each other.
void require_sliders_apart(const std::vector<Case>& sliders);

} // namespace ionskin::mechanics
