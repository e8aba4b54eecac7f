// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/document/case_document.hpp"

#include <string>
#include <vector>

namespace ionskin {

/// Checks the keys of [readout] against one another and against the skin.
void check_readout(const CaseDocument& document, Problems& problems);

/// Notes on [readout] as it is written, for a reader of the results: keys that the circuit does not
/// use, and taxels that share a circuit. One sentence or more each.
std::vector<std::string> notes_on_readout(const CaseDocument& document);

} // namespace ionskin
