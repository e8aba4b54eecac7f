// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/mechanics/output/contact_solution.hpp"

namespace ionskin::mechanics {

/// A short skin with a small slider on a very coarse mesh: the whole path in a fraction of a
/// second.
Case small_case();

/// The instant of a path nearest a time [s].
const SteppedInstant& nearest(const ContactSolution& solution, double time);

} // namespace ionskin::mechanics
