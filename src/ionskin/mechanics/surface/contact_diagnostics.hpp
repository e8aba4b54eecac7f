// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/mechanics/surface/contact_solver.hpp"

namespace ionskin::mechanics {

/// Worst violations of the contact conditions over all cells. Forces are relative to the largest
/// normal force, displacements to the largest indentation of the path.
struct ContactViolations {
  double tension = 0;     ///< pulled cells; under adhesion, normal forces off its law
  double penetration = 0; ///< touching cells off the slider's face, open cells behind it
  double cone = 0;        ///< tangential force beyond the friction limit
  /// Tangential force t against the projection of t + slip / compliance on the friction cone: 0
  /// exactly where a cell sticks, or slips with the limiting force along its slip.
  double slip_law = 0;
  double largest() const;
};

/// Violations of the laws of contact and friction by a state, relative to the scales.
/// @param reference_force,preload scales: largest normal force of a cell, indentation at full load
/// [N], [m]
ContactViolations contact_violations(const ContactProblem& problem, const SurfaceState& state,
                                     double reference_force, double preload);

/// Energy of friction in the step that led to a state [J].
struct FrictionEnergy {
  double stored = 0; ///< behind the step, in the elastic slip
  /// Sum over the cells that dissipate less than nothing, docs/model.md (46), without its sign.
  double created = 0;
};
FrictionEnergy friction_energy(const ContactProblem& problem, const SurfaceState& state);

/// Friction limit less tangential traction of each cell [Pa]; 0 where it slips or is open.
std::vector<double> stick_reserve(const ContactProblem& problem, const CellVector& force);

/// Area that touches without reaching the friction limit over the area that touches; 0 without
/// contact.
double stick_fraction(const ContactProblem& problem, const CellVector& force);

} // namespace ionskin::mechanics
