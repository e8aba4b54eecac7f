// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/mechanics/surface/contact_problem.hpp"

namespace ionskin::mechanics {

/// How the sweeps ended.
struct GaussSeidelResult {
  bool converged = false;
  int sweeps = 0;
};

/// Projected Gauss-Seidel on the cells at a given indentation (Jourdan, Alart and Jean 1998,
/// doi 10.1016/S0045-7825(97)00137-0). Robust, linearly convergent.
/// @param indentation whatever the load of the step [m]
/// @param force start on entry, result on return [N]
/// @param tolerance on the largest change of a sweep over the largest normal force
GaussSeidelResult projected_gauss_seidel(const ContactProblem& problem, const SliderStep& step,
                                         double indentation, CellVector& force, double tolerance,
                                         int most_sweeps);

} // namespace ionskin::mechanics
