// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/mechanics/surface/contact_solver.hpp"

namespace ionskin::mechanics {

/// Binding energy of all cells [J].
double binding_energy(const ContactProblem& problem, const SurfaceState& state);

/// Elastic energy of the skin less the binding energy of the cells [J].
double potential_energy(const ContactProblem& problem, const SurfaceState& state);

/// Work of the slider on the skin between two states, less that of friction [J].
/// @param lowered by how much the slider was lowered where it is off the skin in one of them [m]
double work_on_skin(const SurfaceState& before, const SurfaceState& after, double lowered);

} // namespace ionskin::mechanics
