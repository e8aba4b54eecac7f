// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/document/case_document.hpp"
#include "ionskin/planning/cost_estimate.hpp"

#include <string>

namespace ionskin::apps {

/// Answer of `check --explain` on a valid case, for programs: every value as written, in SI units
/// and where it stands, the explanation, and the cost of a run.
/// @param warning a sentence or nothing
/// Throws UserError when the mesh cannot be built.
std::string check_json(const CaseDocument& document, const std::string& warning,
                       const planning::CostEstimate& cost);

} // namespace ionskin::apps
