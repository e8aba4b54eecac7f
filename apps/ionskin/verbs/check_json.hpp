// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/document/case_document.hpp"
#include "ionskin/planning/cost_estimate.hpp"

#include <string>

namespace ionskin::apps {

/// JSON text that `check --json` prints for a valid case: every value as written, in SI units and
/// with its position in the file, the explanation, and the cost of a run.
/// @param warning lines of warnings; empty for none
/// @param cost estimated cost of a run
/// Throws UserError when the mesh cannot be built.
std::string check_json(const CaseDocument& document, const std::string& warning,
                       const planning::CostEstimate& cost);

} // namespace ionskin::apps
