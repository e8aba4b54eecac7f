// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "verbs/check.hpp"

namespace ionskin::apps {

/// Does the part of `ionskin check` that needs the solver, and prints its answer: reads the strain
/// file of a case and checks it against the ion transport; or finds the contact area of a round
/// slider by a coarse solution. Returns the exit code 0. Throws UserError when the case is not
/// valid.
int check_with_solver(const CheckOptions& options);

} // namespace ionskin::apps
