// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/mechanics/surface/contact_solver.hpp"

namespace ionskin::mechanics {

/// Largest violations of the conditions of contact and friction over all cells. Forces are relative
/// to a reference force and displacements to a reference indentation, so that all are dimensionless
/// [1].
struct ContactViolations {
  double tension = 0;     ///< pull of a cell; with adhesion, normal force off its law
  double penetration = 0; ///< touching cell off the slider's face, or open cell behind it
  double cone = 0;        ///< tangential force beyond the friction limit
  /// Distance of the tangential force t from the projection of t + slip / compliance on the
  /// friction cone: 0 where a cell sticks, or slips with the limiting force along its slip.
  double slip_law = 0;
  /// Largest of the four violations; NaN if one is NaN.
  double largest() const;
};

/// Evaluates how far a state violates the conditions of contact and friction.
/// @param reference_force largest normal force of a cell [N]
/// @param preload indentation at full load [m]
ContactViolations contact_violations(const ContactProblem& problem, const SurfaceState& state,
                                     double reference_force, double preload);

/// Energy of friction in a step, on the meshed part [J].
struct FrictionEnergy {
  double stored = 0; ///< in the elastic slip after the step
  /// Energy created, an error of the friction law: sum of |D| over the cells whose dissipation D in
  /// the step is negative, docs/model.md (46).
  double created = 0;
};
/// Energy of friction in the step that led to a state.
FrictionEnergy friction_energy(const ContactProblem& problem, const SurfaceState& state);

/// Tangential traction that each cell can still take before it slips: friction limit less present
/// traction [Pa]; 0 where the cell slips or is open.
std::vector<double> stick_reserve(const ContactProblem& problem, const CellVector& force);

/// Area of the touching cells below the friction limit over the area of all touching cells [1]; 0
/// without contact.
double stick_fraction(const ContactProblem& problem, const CellVector& force);

} // namespace ionskin::mechanics
