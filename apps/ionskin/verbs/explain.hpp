// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/document/case_document.hpp"
#include "ionskin/planning/cost_estimate.hpp"

#include <string>

namespace ionskin::apps {

/// Text that explains a case before it runs, for `check --explain`: its values in SI units and
/// where they come from, the derived scales, the instants of contact, and the size and cost of both
/// studies. Throws UserError when the mesh cannot be built.
std::string explain(const CaseDocument& document, const planning::CostEstimate& cost);

/// Lines of warnings where a case is outside the assumptions of the poroelastic coupling law; empty
/// for none.
std::string warnings_of_water(const Case& input);

} // namespace ionskin::apps
