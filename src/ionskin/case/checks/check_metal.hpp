// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/document/case_document.hpp"

#include <string>
#include <vector>

namespace ionskin {

/// Checks the sheet resistances of electrodes against the layers, the readout and the model of the
/// ions.
void check_metal(const CaseDocument& document, Problems& problems);

/// Notes on leads whose place does not matter, and on metal that they touch all over.
std::vector<std::string> notes_on_metal(const CaseDocument& document);

} // namespace ionskin
