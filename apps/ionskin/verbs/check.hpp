// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/document/case_document.hpp"
#include "ionskin/planning/cost_estimate.hpp"

#include <optional>
#include <string>
#include <vector>

namespace ionskin::apps {

struct CheckOptions {
  std::string case_path;
  std::vector<std::string> set_edits; ///< "key=value"
  bool explain = false;
  bool json = false; ///< in place of text
};

/// Reads and checks a case and says that it is valid; explains it when asked. Throws UserError.
/// False, with nothing said, where that takes the solver: a strain from a file is to be read, or
/// the cost of a contact explained whose size a coarse solution finds.
bool check(const CheckOptions& options);

/// `check` of a case without a strain file.
/// @param footprint see planning::estimate_cost
void check_case(const CheckOptions& options, const CaseDocument& document,
                const std::optional<mesh::Footprint>& footprint);

/// Prints the answer of `check` on a case without mistakes.
/// @param warning a sentence or nothing
void print_valid(const CheckOptions& options, const CaseDocument& document,
                 const std::string& warning, const planning::CostEstimate& cost);

} // namespace ionskin::apps
