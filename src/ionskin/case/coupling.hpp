// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/laws/coupling/coupling_law.hpp"

namespace ionskin {

/// True if the coupling law of a case describes water transport in the core, with the constants of
/// `Case::water`; false if it has a coefficient k and a shear measure instead.
inline bool moves_water(const Case& input) {
  return laws::coupling_law(input.coupling.law).traits.moves_water;
}

} // namespace ionskin
