// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/document/case_document.hpp"
#include "ionskin/case/text/place.hpp"

namespace ionskin {

/// Keys of a prescribed load beside another strain.source, and laws that it cannot drive. Needs no
/// material, so that it is reported with all that is missing.
void check_prescribed_keys(const CaseDocument& document, Problems& problems);

/// Checks the needs of strain.source = "prescribed": one load, and the keys of its waveform and no
/// others.
void check_prescribed_load(const CaseDocument& document, Problems& problems);

} // namespace ionskin
