// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/finite_layers/plane/box_modes.hpp"

#include <vector>

namespace ionskin::finite_layers {

/// Means of cos and sin of k = first, first + 1, first + 2, ... steps over places along one
/// direction, an interval without size among them being a point, [place, mode].
/// @param step of the wave number [1/m]
ModeTransform mode_means(const std::vector<Interval>& places, double step, Eigen::Index modes,
                         double first = 0);

} // namespace ionskin::finite_layers
