// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"

namespace ionskin::history {

/// Expected number of samples of the strain history during a typical slide, which covers two fifths
/// of the skin's length [1].
double samples_per_slide(const Numerics& numerics);

} // namespace ionskin::history
