// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/mechanics/surface/contact_solver.hpp"

namespace ionskin::mechanics {

/// Binding energy of all cells by adhesion, on the meshed part [J]; 0 without adhesion.
double binding_energy(const ContactProblem& problem, const SurfaceState& state);

/// Potential energy of skin and adhesion: elastic energy of the skin less the binding energy, on
/// the meshed part [J].
double potential_energy(const ContactProblem& problem, const SurfaceState& state);

/// Work that the slider does on the skin between two states, less the work of friction, on the
/// meshed part [J].
/// @param lowered way of the slider downwards, used where it is off the skin in one of the states
///   [m]
double work_on_skin(const SurfaceState& before, const SurfaceState& after, double lowered);

} // namespace ionskin::mechanics
