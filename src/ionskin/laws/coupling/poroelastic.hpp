// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/laws/coupling/coupling_law.hpp"

namespace ionskin::laws {

/// Coupling law `poroelastic`: pressure moves water, and water drags the cations,
/// docs/model.md (22), (23). The fixed charge does not change, and no coefficient is fitted: the
/// constants are the keys `water.NAME` of the case (poroelasticity/streaming_drive.hpp).
struct Poroelastic {
  double coefficient = 0; ///< not used; every coupling law has this member

  static constexpr CouplingTraits traits{.moves_water = true};
  static constexpr auto parameters() { return no_parameters<Poroelastic>; }
};

} // namespace ionskin::laws
