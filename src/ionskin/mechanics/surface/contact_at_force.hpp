// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/mechanics/surface/contact_solver.hpp"

namespace ionskin::mechanics {

/// `solve_contact_step` under a given force: Gauss-Seidel at guessed indentations until the force
/// is near, Newton for forces and indentation together, and a bracketed search over the indentation
/// where Newton cycles. A force of 0 leaves the slider just touching.
SurfaceState solve_contact_at_force(const ContactProblem& problem, const SliderStep& step,
                                    const CellVector& start);

} // namespace ionskin::mechanics
