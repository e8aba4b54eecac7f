// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/document/case_document.hpp"

#include <string>

namespace ionskin {

/// Text of the remedy for a slider that is tilted too far.
std::string remedy_of_tilt();

/// Checks that the tilt of the slider is small, and refuses angles that the model does not support:
/// changing angles with a drive or with adhesion, and roll or yaw between symmetry planes.
/// @param problems collects mistakes
void check_pose(const CaseDocument& document, Problems& problems);

} // namespace ionskin
