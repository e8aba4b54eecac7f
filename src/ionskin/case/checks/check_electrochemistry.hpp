// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/document/case_document.hpp"

namespace ionskin {

/// Checks the ion model: that the cations at rest fit into the core, that the capacitance of the
/// interfaces agrees with the permittivity, and that thin layers suit the coupling law.
/// @param problems collects mistakes
void check_electrochemistry(const CaseDocument& document, Problems& problems);

} // namespace ionskin
