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

/// Solution of Study 1 with its coarser solutions, from which the error is estimated. Made by
/// `solve_mechanics`.
struct SolvedMechanics {
  std::vector<mechanics::ContactSolution> contacts; ///< contact solutions, one for each slider
  /// Records of the coarser solutions by name, see mechanics/coarser_solutions.hpp. Empty where the
  /// case asks for no error estimate or the coarser meshes have no solution.
  std::map<std::string, std::shared_ptr<const MechanicsRecord>> coarser_solutions;
};

/// Solves Study 1 of a case for several friction coefficients together, which share one footprint:
/// the one in the options, or else the one found for the first coefficient (see
/// `mechanics::footprint_friction`). Solves the coarser solutions, too, if the case asks for an
/// error estimate.
/// @param frictions friction coefficients [1]; `input.contact.friction` is not used
/// @returns one entry for each coefficient
/// Throws SolverError, Interrupted, and UserError when the contact reaches the edge of the skin or
/// needs more memory than there is.
std::vector<SolvedMechanics> solve_mechanics(const Case& input,
                                             const std::vector<double>& frictions,
                                             const mechanics::ContactOptions& options,
                                             base::Timers& timers);

/// Solves the coarser solutions for a record that has none and adds them to it; adds none where
/// they have no solution.
void add_coarser_solutions(const Case& input, const mechanics::ContactOptions& options,
                           MechanicsRecord& record);

/// Reduces a solution of Study 1 to the record that the rest of the run needs, with the strain
/// history.
/// @param progress receives the activity "strain history"
MechanicsRecord record_mechanics(const Case& input, const SolvedMechanics& solved,
                                 const base::ProgressCallback& progress = base::no_progress);

} // namespace ionskin::study
