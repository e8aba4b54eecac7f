// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"

namespace ionskin::mechanics {

/// Part of a usual slide, two fifths of the skin, between instants that are kept at least; the
/// error of straight lines between them falls with its square.
double path_resolution(const Numerics& numerics);

/// Longest way between instants of a path that are kept [m].
double longest_kept_travel(const Case& input);

/// Longest way that the contact is stepped over at once [m].
/// Longest turn of a slider about z in a step [rad].
double longest_step_turn(const Numerics& numerics);
double longest_step_travel(const Case& input);

} // namespace ionskin::mechanics
