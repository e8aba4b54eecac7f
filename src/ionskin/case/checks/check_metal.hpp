// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/document/case_document.hpp"

#include <string>
#include <vector>

namespace ionskin {

/// What must hold between the sheet resistances of electrodes, the layers, the readout and the
/// model of the ions.
void check_metal(const CaseDocument& document, Problems& problems);

/// Of leads whose place does not matter, and of metal that they touch all over.
std::vector<std::string> notes_on_metal(const CaseDocument& document);

} // namespace ionskin
