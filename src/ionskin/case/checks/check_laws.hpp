// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/base/error.hpp"
#include "ionskin/case/document/case_document.hpp"

namespace ionskin {

/// Parameters that are given to a law without them.
void check_laws(const CaseDocument& document, Problems& problems);

} // namespace ionskin
