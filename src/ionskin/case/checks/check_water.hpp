// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/document/case_document.hpp"
#include "ionskin/case/text/place.hpp"

namespace ionskin {

/// Refuses keys that do not belong to the coupling law: those of [water] if the law does not move
/// water, coefficient and measure if it does. Reports missing alternatives in [water]. Needs no
/// material, so that it can run before missing keys are reported.
/// @param problems collects mistakes
void check_water_keys(const CaseDocument& document, Problems& problems);

/// Checks the keys of [water] against one another and against the elastic constants of the core.
/// Does nothing if the coupling law does not move water, or if there are mistakes already.
/// @param problems collects mistakes
void check_water(const CaseDocument& document, Problems& problems);

} // namespace ionskin
