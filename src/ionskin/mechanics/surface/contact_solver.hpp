// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/mechanics/surface/contact_problem.hpp"

namespace ionskin::mechanics {

/// Equilibrium of slider and skin surface, the result of a contact step.
struct SurfaceState {
  CellVector force;         ///< of the slider on the cells [N]
  CellVector surface;       ///< displacement of the cells [m]
  std::vector<double> slip; ///< length of the slip of each cell in the step [m]
  SliderStep step;          ///< step that led here
  int iterations = 0;
  double indentation = 0; ///< of the slider, given or found [m]
};

/// Solves one contact step by `ContactNewton` and, where that fails, by a series of loads that grow
/// to the given one. A force of 0 leaves the slider just touching the skin. Throws SolverError
/// where no solution is found.
/// @param start forces to start from, such as those of the state before, [3 cells] [N]
SurfaceState solve_contact_step(const ContactProblem& problem, const SliderStep& step,
                                const CellVector& start);

/// Makes the state of a solved step: adds displacements and slip to its forces and indentation.
SurfaceState surface_state(const ContactProblem& problem, const SliderStep& step, CellVector force,
                           double indentation, int iterations);

} // namespace ionskin::mechanics
