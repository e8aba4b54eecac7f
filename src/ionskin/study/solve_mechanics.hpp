// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/base/timers.hpp"
#include "ionskin/mechanics/solve_contact.hpp"
#include "ionskin/study/mechanics_record.hpp"

#include <optional>
#include <vector>

namespace ionskin::study {

/// Study 1, and the same on a companion mesh of twice the sizes, which tells the error.
struct SolvedMechanics {
  mechanics::ContactSolution contact;
  std::optional<mechanics::ContactSolution> companion; ///< empty where that mesh has no solution
};

/// Solves a case for several friction coefficients together, which share one footprint: that of the
/// options, or that of the first (`mechanics::footprint_friction`).
/// Throws SolverError, Interrupted.
std::vector<SolvedMechanics> solve_mechanics(const Case& input,
                                             const std::vector<double>& frictions,
                                             const mechanics::ContactOptions& options,
                                             base::Timers& timers);

/// Condenses both into what the rest of the run needs.
MechanicsRecord record_mechanics(const Case& input, const SolvedMechanics& solved, int threads);

} // namespace ionskin::study
