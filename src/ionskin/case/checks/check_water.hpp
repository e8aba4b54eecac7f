// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/document/case_document.hpp"
#include "ionskin/case/text/place.hpp"

namespace ionskin {

/// What the keys of [water] must be to one another and to the core's elastic constants; keys of
/// laws that do not move water beside one that does, and the reverse.
void check_water(const CaseDocument& document, Problems& problems);

} // namespace ionskin
