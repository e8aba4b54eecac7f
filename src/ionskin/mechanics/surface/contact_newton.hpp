// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/mechanics/surface/contact_problem.hpp"

namespace ionskin::mechanics {

/// How Newton's method ended.
struct NewtonResult {
  bool converged = false;
  int iterations = 0;
};

/// Semi-smooth Newton on the projection form of contact and friction (Alart and Curnier 1991,
/// doi 10.1016/0045-7825(91)90022-X). Under a given force the indentation is one more unknown and
/// the sum of the normal forces one more equation. Exact once stick, slip and separation are right;
/// needs a good start.
/// @param force start on entry; the result on return when converged [N]
/// @param indentation likewise, under a given force; the given one otherwise [m]
/// @param tolerance on the projection residual over the largest normal force
NewtonResult contact_newton(const ContactProblem& problem, const SliderStep& step,
                            CellVector& force, double& indentation, double tolerance = 1e-10,
                            int most_iterations = 15);

} // namespace ionskin::mechanics
