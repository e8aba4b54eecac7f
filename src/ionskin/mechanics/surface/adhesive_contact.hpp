// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/mechanics/surface/contact_solver.hpp"

#include <vector>

namespace ionskin::mechanics {

/// What an adhesive contact is before a step, on which it depends what it is behind it.
struct AdhesiveStart {
  CellVector force;            ///< [N]
  std::vector<double> opening; ///< of the cells [m]
  double indentation = 0;      ///< [m]
};

/// A contact that nothing has touched yet.
AdhesiveStart far_apart(const ContactProblem& problem);
AdhesiveStart start_from(const ContactProblem& problem, const SurfaceState& state);

/// `solve_contact_step` with adhesion, which need not have one solution: the one that a slow motion
/// from the start comes to. At an indentation the pulls are held at those of the openings, the
/// contact is solved under them, which has one solution, and the pulls are those of its openings
/// next, docs/model.md (44): the energy falls from one to the next until it cannot, also where the
/// contact jumps. Under a force the slider goes up or down until it carries the force; where it
/// comes off the skin before that, the state is without forces.
SurfaceState solve_adhesive_step(const ContactProblem& problem, const SliderStep& step,
                                 const AdhesiveStart& start);

/// Of all cells [J].
double binding_energy(const ContactProblem& problem, const SurfaceState& state);

/// Elastic energy of the skin less the binding energy of the cells [J].
double potential_energy(const ContactProblem& problem, const SurfaceState& state);

/// Work of the slider on the skin between two states, less that of friction [J].
/// @param lowered by how much the slider was lowered where it is off the skin in one of them [m]
double work_on_skin(const SurfaceState& before, const SurfaceState& after, double lowered);

} // namespace ionskin::mechanics
