// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "verbs/check.hpp"

namespace ionskin::apps {

/// `check` where it takes the solver: of a case whose strain comes from a file, what `run` would
/// say of it; of a round slider, whose contact a coarse solution finds. Throws UserError.
int check_with_solver(const CheckOptions& options);

} // namespace ionskin::apps
