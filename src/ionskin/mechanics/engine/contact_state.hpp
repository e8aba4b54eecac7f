// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/mechanics/output/contact_solution.hpp"
#include "ionskin/mechanics/skin/skin_model.hpp"
#include "ionskin/mechanics/surface/contact_solver.hpp"

namespace ionskin::mechanics {

/// Fills in a contact state from a solved step: forces of the full skin, moments, tractions, areas,
/// energies and diagnostics, everything but the strain.
/// @param reference_force,reference_indentation scales of the diagnostics [N], [m]
/// @param destination state to fill in, initially empty
void describe(const SkinModel& model, const SurfaceState& state, const ContactProblem& problem,
              double reference_force, double reference_indentation, ContactState& destination);

/// Largest magnitude of the normal force on a cell [N].
double largest_normal_force(const CellVector& force);

} // namespace ionskin::mechanics
