// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/document/case_document.hpp"
#include "ionskin/case/text/place.hpp"

namespace ionskin {

/// Keys of laws that do not move water beside one that does, and the reverse; keys of [water] of
/// which one of several is missing. Needs no material, so that it is reported with all that is
/// missing.
void check_water_keys(const CaseDocument& document, Problems& problems);

/// Checks the keys of [water] against one another and against the core's elastic constants.
void check_water(const CaseDocument& document, Problems& problems);

} // namespace ionskin
