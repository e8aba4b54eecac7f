// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"

namespace ionskin::history {

/// Samples that a usual slide, over two fifths of the skin, is expected to have.
double samples_per_slide(const Numerics& numerics);

} // namespace ionskin::history
