// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"

namespace ionskin::history {

/// Samples of steady sliding over a leg with the usual number of interpolation nodes.
double samples_per_slide(const Numerics& numerics);

} // namespace ionskin::history
