// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/document/case_document.hpp"

namespace ionskin {

/// Checks the Prony series of materials: as many shares as times, ascending times, and shares that
/// add up to less than one. Refuses relaxation where the model is elastic: in electrodes, and in a
/// core under contact, a strain file, a held compression or water pressure outside.
/// @param problems collects mistakes
void check_relaxation(const CaseDocument& document, Problems& problems);

} // namespace ionskin
