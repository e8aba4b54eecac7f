// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/mechanics/surface/contact_problem.hpp"

namespace ionskin::mechanics {

/// One equilibrium of slider and skin surface.
struct SurfaceState {
  CellVector force;         ///< [N]
  CellVector surface;       ///< displacement, normal downwards [m]
  std::vector<double> slip; ///< length of the slip increment per cell [m]
  SliderStep step;          ///< step that led here
  int iterations = 0;
  double indentation = 0; ///< given, or found to carry the given force [m]
};

/// One step by itself, by `ContactNewton`, and where that fails under loads that grow to it. A
/// force of 0 leaves the slider just touching. Throws SolverError where no solution is found.
/// @param start forces to start from, such as those of the state before [N]
SurfaceState solve_contact_step(const ContactProblem& problem, const SliderStep& step,
                                const CellVector& start);

/// The state under forces that solve a step.
SurfaceState surface_state(const ContactProblem& problem, const SliderStep& step, CellVector force,
                           double indentation, int iterations);

} // namespace ionskin::mechanics
