// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/base/error.hpp"
#include "ionskin/case/document/case_document.hpp"

namespace ionskin {

/// Checks that a slider on a drive has one motion under its friction law. Needs a sound motion.
void check_drive(const CaseDocument& document, Problems& problems);

} // namespace ionskin
