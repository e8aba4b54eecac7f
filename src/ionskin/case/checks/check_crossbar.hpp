// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/document/case_document.hpp"

#include <string>
#include <vector>

namespace ionskin {

/// Checks the circuits that connect the lines of a crossbar (readout.taxels.wiring) to the ground,
/// and keys that a crossbar excludes.
/// @param problems collects mistakes
void check_crossbar(const CaseDocument& document, Problems& problems);

/// Notes for `Case::notes` on a crossbar whose readout cannot distinguish the crossings of a
/// column; empty if there is nothing to note.
std::vector<std::string> notes_on_crossbar(const CaseDocument& document);

} // namespace ionskin
