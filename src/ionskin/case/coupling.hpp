// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"

namespace ionskin {

/// Whether the coupling law of a case moves water, by the constants of [water], instead of having
/// a coefficient k and a measure of shear.
inline bool moves_water(const Case& input) {
  return input.coupling.law == "poroelastic";
}

} // namespace ionskin
