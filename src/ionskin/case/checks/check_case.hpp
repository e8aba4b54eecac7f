// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/document/case_document.hpp"

namespace ionskin {

/// Checks the keys of a case against one another: layers, laws, readout, slider and its path,
/// preload, instants within the run; and that a strain file exists. Each value by itself must
/// already be in range. Throws UserError with all mistakes, each with the positions of the keys
/// involved and a remedy.
void check_case(const CaseDocument& document);

} // namespace ionskin
