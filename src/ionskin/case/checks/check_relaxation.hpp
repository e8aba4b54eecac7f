// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/document/case_document.hpp"

namespace ionskin {

/// Prony series that are none, and cores that relax where only elastic ones are solved, are
/// collected.
void check_relaxation(const CaseDocument& document, Problems& problems);

} // namespace ionskin
