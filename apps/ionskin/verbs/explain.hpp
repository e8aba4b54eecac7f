// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/document/case_document.hpp"
#include "ionskin/planning/cost_estimate.hpp"

#include <string>

namespace ionskin::apps {

/// Meaning of a case before it runs: its values in SI units and where they come from, the scales
/// that follow, the instants of contact, and the size and cost of both studies. Throws UserError
/// when the mesh cannot be built.
std::string explain(const CaseDocument& document, const planning::CostEstimate& cost);

/// Warnings where a case leaves what the law of the water holds for; else empty.
std::string warnings_of_water(const Case& input);

} // namespace ionskin::apps
