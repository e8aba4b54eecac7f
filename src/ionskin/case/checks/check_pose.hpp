// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/document/case_document.hpp"

#include <string>

namespace ionskin {

/// Remedy of a tilt that is too large.
std::string remedy_of_tilt();

/// Checks the angles of the slider, and refuses them where they are not carried.
void check_pose(const CaseDocument& document, Problems& problems);

} // namespace ionskin
