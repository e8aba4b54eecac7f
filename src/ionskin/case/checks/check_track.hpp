// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/document/case_document.hpp"

namespace ionskin {

/// The part of the slider that touches at once (all of a flat one, the lowest line or point of a
/// round one) must stay inside the skin at both ends of its track (and so between them); where it
/// covers the whole width between symmetry planes, only along x.
void check_track(const CaseDocument& document, Problems& problems);

} // namespace ionskin
