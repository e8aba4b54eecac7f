// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/base/error.hpp"
#include "ionskin/case/document/case_document.hpp"

namespace ionskin {

/// Parameters that are given to a law without them.
void check_laws(const CaseDocument& document, Problems& problems);

/// Friction of the fastest slide, where it depends on speed. Needs a sound motion.
void check_friction_of_speed(const CaseDocument& document, Problems& problems);

/// Checks what adhesion cannot be combined with, and how far it reaches. Needs a sound motion.
void check_adhesion(const CaseDocument& document, Problems& problems);

} // namespace ionskin
