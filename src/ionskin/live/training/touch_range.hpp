// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/live/touches/random_touches.hpp"

namespace ionskin::live {

/// Takes the range of positions, loads and speeds from the motion of a case; no tilt and no
/// rotation. Throws UserError where the slider never touches.
TouchRange touch_range(const Case& input);

} // namespace ionskin::live
