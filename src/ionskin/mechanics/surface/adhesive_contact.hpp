// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/mechanics/surface/contact_solver.hpp"

#include <optional>
#include <vector>

namespace ionskin::mechanics {

/// State of an adhesive contact before a step, on which the state after the step depends.
struct AdhesiveStart {
  CellVector force;            ///< [N]
  std::vector<double> opening; ///< of the cells [m]
  double indentation = 0;      ///< [m]
};

/// A contact that nothing has touched yet.
AdhesiveStart far_apart(const ContactProblem& problem);
AdhesiveStart start_from(const ContactProblem& problem, const SurfaceState& state);

/// The contact with adhesion at an indentation, which need not have one solution: the one that a
/// slow motion from the start comes to. The pulls are held at those of the openings, the contact is
/// solved under them, which has one solution, and the pulls are those of its openings next,
/// docs/model.md (44): the energy falls from one to the next until it cannot, also where the
/// contact jumps.
SurfaceState relaxed_contact(const ContactProblem& problem, const SliderStep& step,
                             const AdhesiveStart& start);

/// The solution of a step that Newton's method finds from forces, with the pulls as the law has
/// them; empty where it ends far from them, or in an equilibrium that cannot last.
/// @param indentation to start from, under a given force [m]
std::optional<SurfaceState> nearby_solution(const ContactProblem& problem, const SliderStep& step,
                                            const CellVector& start, double indentation);

/// Sum of the magnitudes of all components [N].
double sum_of_magnitudes(const CellVector& force);

} // namespace ionskin::mechanics
