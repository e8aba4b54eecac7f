// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/document/case_document.hpp"

namespace ionskin {

/// Checks that the ions at rest fit into the core.
void check_electrochemistry(const CaseDocument& document, Problems& problems);

} // namespace ionskin
