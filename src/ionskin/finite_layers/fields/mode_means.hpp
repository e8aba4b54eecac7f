// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/finite_layers/plane/box_modes.hpp"

#include <vector>

namespace ionskin::finite_layers {

/// Calculates the means of cos(k x) and sin(k x) over places x along one direction, for equally
/// spaced wave numbers k = (first + i) * step, i = 0, 1, ..., [place, mode] [1]. An interval of
/// size 0 is a point.
/// @param places intervals along the direction [m]
/// @param step of the wave number [1/m]
/// @param modes number of wave numbers
/// @param first wave number of the first mode, in steps [1]
ModeTransform mode_means(const std::vector<Interval>& places, double step, Eigen::Index modes,
                         double first = 0);

} // namespace ionskin::finite_layers
