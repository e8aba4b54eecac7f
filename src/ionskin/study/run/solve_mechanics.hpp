// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/base/timers.hpp"
#include "ionskin/mechanics/solve_contact.hpp"
#include "ionskin/study/store/mechanics_record.hpp"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace ionskin::study {

/// Study 1 and its coarser solutions, which give the error.
struct SolvedMechanics {
  std::vector<mechanics::ContactSolution> contacts; ///< one for each slider
  /// Records of the coarser solutions by name, see mechanics/coarser_solutions.hpp; empty where
  /// their mesh has no solution and where no error is asked for.
  std::map<std::string, std::shared_ptr<const MechanicsRecord>> coarser_solutions;
};

/// Solves a case for several friction coefficients together, which share one footprint: that of the
/// options, or that of the first (`mechanics::footprint_friction`).
/// Throws SolverError, Interrupted.
std::vector<SolvedMechanics> solve_mechanics(const Case& input,
                                             const std::vector<double>& frictions,
                                             const mechanics::ContactOptions& options,
                                             base::Timers& timers);

/// Solves and adds the coarser solutions of a record that has none; none where they have no
/// solution.
void add_coarser_solutions(const Case& input, const mechanics::ContactOptions& options,
                           MechanicsRecord& record);

/// Condenses it into what the rest of the run needs.
/// @param progress called with "strain history"
MechanicsRecord record_mechanics(const Case& input, const SolvedMechanics& solved,
                                 const base::ProgressCallback& progress = base::no_progress);

} // namespace ionskin::study
