// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/mechanics/surface/contact_solver.hpp"

namespace ionskin::mechanics {

/// Solves the limit of long sliding under a constant load: every touching cell slips along
/// `direction`, and its tangential force is the friction limit in that direction.
/// @param direction of the slider's travel, a unit vector
/// @param travel of the slider, reported as the slip of each cell [m]
/// Throws SolverError when no contact is found, or when the friction law gives no finite number
/// there.
SurfaceState steady_sliding(const ContactProblem& problem, const SliderLoad& load,
                            const std::array<double, 2>& direction, double travel);

} // namespace ionskin::mechanics
