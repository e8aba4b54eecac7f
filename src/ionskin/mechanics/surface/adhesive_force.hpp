// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/mechanics/surface/adhesive_contact.hpp"

namespace ionskin::mechanics {

/// The contact with adhesion under a force: the slider goes up or down from the start until it
/// carries the force; where it comes off the skin before that, the state is without forces.
SurfaceState adhesive_contact_at_force(const ContactProblem& problem, const SliderStep& step,
                                       const AdhesiveStart& start);

} // namespace ionskin::mechanics
