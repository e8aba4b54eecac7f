// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/document/case_document.hpp"

namespace ionskin {

/// Checks that the keys of the slider go together: keys that its shape does not have, and what the
/// shape itself finds, such as a plan larger than the round body or the height map.
void check_slider(const CaseDocument& document, Problems& problems);

/// Notes on a slider that passes the checks: a shape that was changed by an edit and keeps the plan
/// of the one in the file.
std::vector<std::string> notes_on_slider(const CaseDocument& document);

} // namespace ionskin
