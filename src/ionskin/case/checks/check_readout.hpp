// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/document/case_document.hpp"

#include <string>
#include <vector>

namespace ionskin {

/// Checks the keys of [readout] against one another and against the skin: circuits, taxels, scan.
/// @param problems collects mistakes
void check_readout(const CaseDocument& document, Problems& problems);

/// Notes for `Case::notes` on [readout]: keys that no circuit uses, and taxels that share one
/// circuit. Empty if there is nothing to note.
std::vector<std::string> notes_on_readout(const CaseDocument& document);

} // namespace ionskin
