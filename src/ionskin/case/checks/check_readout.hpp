// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/document/case_document.hpp"

#include <string>
#include <vector>

namespace ionskin {

/// What must hold between the keys of [readout], and between them and the skin.
void check_readout(const CaseDocument& document, Problems& problems);

/// What a reader of the results should know of [readout] as it is written: keys that the circuit
/// does not use, and taxels that share a circuit. One sentence or more each.
std::vector<std::string> notes_on_readout(const CaseDocument& document);

} // namespace ionskin
