// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/document/case_document.hpp"

#include <string>
#include <vector>

namespace ionskin {

/// Checks the sheet resistances of electrodes against the roles of the layers, the taxels and the
/// ion model.
/// @param problems collects mistakes
void check_metal(const CaseDocument& document, Problems& problems);

/// Notes for `Case::notes` on keys without effect: readout.contact without a sheet resistance, or a
/// sheet resistance where leads touch the metal everywhere. Empty if there are none.
std::vector<std::string> notes_on_metal(const CaseDocument& document);

} // namespace ionskin
