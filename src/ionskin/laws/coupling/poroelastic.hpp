// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/laws/coupling/coupling_law.hpp"

namespace ionskin::laws {

/// Coupling law `poroelastic`: pressure moves water, which drags the cations, by the constants of
/// [water]; the fixed charge stays as it is and nothing is fitted (poroelasticity/streaming_drive).
struct Poroelastic {
  double coefficient = 0; ///< without a meaning

  static constexpr CouplingTraits traits{.moves_water = true};
  static constexpr auto parameters() { return no_parameters<Poroelastic>; }
};

} // namespace ionskin::laws
