// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/document/case_document.hpp"

namespace ionskin {

/// Checks between the keys of a case whose single values are in range: the stack of layers, the
/// slider's shape and whole track, preload, instants within the run, the strain file's existence.
/// Throws UserError with all mistakes: what, the places of all keys involved, remedy.
void check_case(const CaseDocument& document);

} // namespace ionskin
