// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/mechanics/surface/contact_solver.hpp"

namespace ionskin::mechanics {

/// The limit of long sliding under a constant load: every touching cell slips along `direction`,
/// so its tangential force is the friction limit against that direction.
/// @param travel of the slider, which becomes the slip [m]
/// Throws SolverError when no contact is found, and when the friction law gives no finite number
/// there.
SurfaceState steady_sliding(const ContactProblem& problem, const SliderLoad& load,
                            const std::array<double, 2>& direction, double travel);

} // namespace ionskin::mechanics
