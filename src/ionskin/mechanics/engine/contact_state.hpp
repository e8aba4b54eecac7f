// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/mechanics/output/contact_solution.hpp"
#include "ionskin/mechanics/skin/skin_model.hpp"
#include "ionskin/mechanics/surface/contact_solver.hpp"

namespace ionskin::mechanics {

/// Everything of a state but its strain and what goes with that: forces of the full skin, tractions
/// and diagnostics.
/// @param reference_force, reference_indentation scales of the diagnostics [N], [m]
void describe(const SkinModel& model, const SurfaceState& state, const ContactProblem& problem,
              double reference_force, double reference_indentation, ContactState& destination);

/// Largest normal force of a cell [N].
double largest_normal_force(const CellVector& force);

} // namespace ionskin::mechanics
