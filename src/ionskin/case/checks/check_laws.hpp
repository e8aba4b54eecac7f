// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/base/error.hpp"
#include "ionskin/case/document/case_document.hpp"

namespace ionskin {

/// Refuses parameters of the sections [contact] and [coupling] that the chosen law does not have.
/// @param problems collects mistakes
void check_laws(const CaseDocument& document, Problems& problems);

/// Checks that the coefficient of friction at the fastest slide is not above the largest that is
/// allowed.
/// @param document a case that `check_motion` accepts
/// @param problems collects mistakes
void check_friction_of_speed(const CaseDocument& document, Problems& problems);

/// Checks an adhesive law: no slider on a drive, and a range of adhesion below the thickness of the
/// skin. Does nothing under other laws.
/// @param document a case that `check_motion` accepts
/// @param problems collects mistakes
void check_adhesion(const CaseDocument& document, Problems& problems);

} // namespace ionskin
