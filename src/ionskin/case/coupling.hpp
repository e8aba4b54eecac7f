// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/laws/coupling/coupling_law.hpp"

namespace ionskin {

/// True if the coupling law of a case moves water, by the constants of [water], instead of having a
/// coefficient k and a measure of shear.
inline bool moves_water(const Case& input) {
  return laws::coupling_law(input.coupling.law).traits.moves_water;
}

} // namespace ionskin
