// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/mechanics/surface/adhesive_contact.hpp"

namespace ionskin::mechanics {

/// Solves an adhesive contact under a given normal force: moves the slider up or down from the
/// start until it carries the force. Where the slider comes off the skin before that, the state has
/// no forces. Throws SolverError when no height is found.
SurfaceState adhesive_contact_at_force(const ContactProblem& problem, const SliderStep& step,
                                       const AdhesiveStart& start);

} // namespace ionskin::mechanics
