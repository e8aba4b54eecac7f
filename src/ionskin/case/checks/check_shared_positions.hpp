// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/document/case_document.hpp"

namespace ionskin {

/// Whether `numerics.shared_positions` is a rectangle on the skin that holds the slider's way.
/// Needs a sound motion.
void check_shared_positions(const CaseDocument& document, Problems& problems);

} // namespace ionskin
