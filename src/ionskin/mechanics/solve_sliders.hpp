// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/mechanics/solve_contact.hpp"

#include <vector>

namespace ionskin::mechanics {

/// Study 1 of several sliders on one skin, docs/model.md (81): each presses the skin that the
/// others have moved. The paths are solved one after the other, each with the forces that the last
/// passes found for the others, until no force changes by more than the path resolves.
/// @param sliders cases alike but for slider, motion and friction, whose cycles last equally long
/// @returns one solution each, of half of the skin where all go along its middle
/// Throws UserError where the cases do not go together, or two sliders come nearer to each other
/// than short waves in the skin reach, before any path is solved; SolverError where the passes do
/// not converge.
std::vector<ContactSolution> solve_sliders(const std::vector<Case>& sliders,
                                           const ContactOptions& options, base::Timers& timers);

/// Refuses sliders that are sure to come nearer to each other than short waves reach, before any
/// contact is solved: of a round one, whose contact is not known, its lowest point counts alone.
/// Throws UserError.
void require_sliders_apart(const std::vector<Case>& sliders);

} // namespace ionskin::mechanics
