// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/base/error.hpp"
#include "ionskin/case/document/case_document.hpp"

namespace ionskin {

/// Checks the keys of the drive, and that the motion of a slider on a drive is unique under its
/// friction law: if friction falls with speed, the drive needs a mass or a damper.
/// @param document a case that `check_motion` accepts
/// @param problems collects mistakes
void check_drive(const CaseDocument& document, Problems& problems);

} // namespace ionskin
