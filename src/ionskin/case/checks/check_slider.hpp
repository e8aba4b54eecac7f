// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/document/case_document.hpp"

namespace ionskin {

/// Checks the keys of the slider: keys that its shape does not have, softness, pose, and the
/// conflicts that the shape itself reports, such as a plan larger than the round body or the height
/// map.
/// @param problems collects mistakes
void check_slider(const CaseDocument& document, Problems& problems);

/// Notes for `Case::notes` on a slider whose shape a `--set` edit changed while its plan is still
/// that of the case file. Empty if there is nothing to note.
std::vector<std::string> notes_on_slider(const CaseDocument& document);

} // namespace ionskin
