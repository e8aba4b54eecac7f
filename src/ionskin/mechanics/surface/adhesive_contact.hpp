// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/mechanics/surface/contact_solver.hpp"

#include <optional>
#include <vector>

namespace ionskin::mechanics {

/// State of an adhesive contact before a step. Several solutions may exist after the step; this
/// state decides which one is found.
struct AdhesiveStart {
  CellVector force;            ///< [N]
  std::vector<double> opening; ///< distance of each cell from the slider [m]
  double indentation = 0;      ///< [m]
};

/// State before the first touch: no forces, and the slider just out of the range of adhesion.
AdhesiveStart far_apart(const ContactProblem& problem);
/// State after a solved step, as the start of the next step.
AdhesiveStart start_from(const ContactProblem& problem, const SurfaceState& state);

/// Solves an adhesive contact at a given indentation. Of several solutions it finds the one that a
/// slow motion from the start reaches, docs/model.md (44): it repeatedly solves the contact under
/// pulls held at those of the last openings, which has a single solution, and each time the energy
/// falls, also where the contact jumps. Throws SolverError when this does not converge.
SurfaceState relaxed_contact(const ContactProblem& problem, const SliderStep& step,
                             const AdhesiveStart& start);

/// Solves an adhesive contact by Newton's method from given forces. Empty where Newton's method
/// fails, ends far from the start, or finds an unstable equilibrium.
/// @param start forces to start from [N]
/// @param indentation to start from, where the step prescribes a force [m]
std::optional<SurfaceState> nearby_solution(const ContactProblem& problem, const SliderStep& step,
                                            const CellVector& start, double indentation);

/// Sum of the magnitudes of all force components over all cells [N].
double sum_of_magnitudes(const CellVector& force);

} // namespace ionskin::mechanics
