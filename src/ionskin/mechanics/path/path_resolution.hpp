// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"

namespace ionskin::mechanics {

/// Longest interval between stored instants of a path, as a share of a typical slide over two
/// fifths of the skin's length [1]. The error of linear interpolation between instants falls with
/// its square.
double path_resolution(const Numerics& numerics);

/// Longest travel of the slider between two stored instants of a path [m].
double longest_kept_travel(const Case& input);

/// Longest turn of a slider about z in one contact step [rad].
double longest_step_turn(const Numerics& numerics);
/// Longest travel of the slider in one contact step [m].
double longest_step_travel(const Case& input);

} // namespace ionskin::mechanics
