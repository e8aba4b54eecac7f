// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/document/case_document.hpp"
#include "ionskin/case/text/place.hpp"

namespace ionskin {

/// Refuses keys of a prescribed load with another strain.source, and coupling laws that a
/// prescribed load cannot drive. Needs no material, so that it can run before missing keys are
/// reported.
/// @param problems collects mistakes
void check_prescribed_keys(const CaseDocument& document, Problems& problems);

/// Checks a case with strain.source = "prescribed": one load, or water under pressure outside;
/// small enough; and the keys of its waveform and of no other.
/// @param problems collects mistakes
void check_prescribed_load(const CaseDocument& document, Problems& problems);

} // namespace ionskin
