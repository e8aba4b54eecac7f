// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"

namespace ionskin::verification {

/// Case of the baseline skin at the coarse preset, with its mechanics only: skin 15 x 2 mm, layers
/// 10/180/10 um, slider 3 x 1.5 mm, 1 um preload, 6 mm stroke, friction coefficient 0.3.
Case baseline_case();

} // namespace ionskin::verification
