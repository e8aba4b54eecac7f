// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/document/case_document.hpp"

namespace ionskin {

/// Checks that the part of the slider that touches at once (the whole plan of a flat slider, the
/// lowest line or point of a round one) lies inside the skin at both ends of its path, or at every
/// waypoint, and so in between. A slider that covers the whole width between symmetry planes is
/// checked only along x. Also refuses a motion.direction of zero length.
/// @param problems collects mistakes
void check_track(const CaseDocument& document, Problems& problems);

} // namespace ionskin
