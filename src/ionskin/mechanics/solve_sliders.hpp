// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/mechanics/solve_contact.hpp"

#include <vector>

namespace ionskin::mechanics {

/// Study 1 of several sliders on one skin, docs/model.md (81): each presses the skin that the
/// others have moved. The paths are solved one after the other, each with the forces that the last
/// passes found for the others, until no force changes by more than the path resolves.
/// @param sliders cases alike but for slider, motion and friction, whose cycles last equally long
/// @returns one solution each, of the whole skin
/// Throws UserError where the cases do not go together, or two sliders come nearer to each other
/// than short waves in the skin reach, before any path is solved; SolverError where the passes do
/// not converge.
std::vector<ContactSolution> solve_sliders(const std::vector<Case>& sliders,
                                           const ContactOptions& options, base::Timers& timers);

} // namespace ionskin::mechanics
