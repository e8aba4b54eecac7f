// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/document/case_document.hpp"
#include "ionskin/planning/cost_estimate.hpp"

#include <optional>
#include <string>
#include <vector>

namespace ionskin::apps {

/// Options of `ionskin check`.
struct CheckOptions {
  std::string case_path;
  std::vector<std::string> set_edits; ///< "key=value"
  bool explain = false;
  bool json = false; ///< true to print JSON instead of text
};

/// Runs `ionskin check`: reads and checks a case and prints that it is valid, with its explanation
/// if asked.
/// @return false, with nothing printed, if the check needs the solver: for a strain file, and for a
/// round slider whose contact area only a coarse solution finds, where its cost is to be explained
/// or it may leave the skin. `check_with_solver` does the check then.
/// Throws UserError when the case is not valid.
bool check(const CheckOptions& options);

/// Checks the mesh, the contact and the cost of a case that was read, and prints the answer of
/// `check`. The strain must not come from a file.
/// @param footprint bounds of the contact as a coarse solution found them; nullopt where it was not
/// solved, see planning::estimate_cost
/// Throws UserError when the mesh cannot be built or the slider does not touch.
void check_case(const CheckOptions& options, const CaseDocument& document,
                const std::optional<mesh::Footprint>& footprint);

/// Prints the answer of `check` on a valid case, as text or JSON.
/// @param warning lines of warnings; empty for none
/// @param cost estimated cost of a run
void print_valid(const CheckOptions& options, const CaseDocument& document,
                 const std::string& warning, const planning::CostEstimate& cost);

} // namespace ionskin::apps
