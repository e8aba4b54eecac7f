// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/document/case_document.hpp"

#include <string>
#include <vector>

namespace ionskin {

/// Checks what joins the lines of a crossbar (readout.taxels.wiring) to the ground.
void check_crossbar(const CaseDocument& document, Problems& problems);

/// Notes on a crossbar whose reading tells no crossings apart, for a reader of the results; one
/// sentence or more each.
std::vector<std::string> notes_on_crossbar(const CaseDocument& document);

} // namespace ionskin
