// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case_document.hpp"

namespace ionskin {

/// What must hold between the keys of [readout], and between them and the skin.
void check_readout(const CaseDocument& document, Problems& problems);

} // namespace ionskin
