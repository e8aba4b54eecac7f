// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/laws/coupling/coupling_law.hpp"

namespace ionskin::laws {

/// Coupling law `pair-generation`: shear dissociates pairs, so that every fixed charge comes with a
/// mobile ion released at the same place, docs/model.md (21),
///   cf / c0 = 1 + k gamma,   source of v c / c0 = d(k gamma)/dt.
/// The core stays neutral everywhere: the charges of the electrodes add up to nothing, and the
/// integral of v c follows that of cf exactly. What drives the current is the diffusion of the
/// released ions away from their fixed partners. Where shear recedes, pairs recombine. Source: the
/// `fixed-charge` law made to conserve charge, as a dissociation reaction demands.
struct PairGeneration {
  double coefficient = 0; ///< k [1]

  static constexpr CouplingTraits traits{.releases_ions = true};
  static constexpr auto parameters() { return no_parameters<PairGeneration>; }
  /// cf / c0 [1] of the shear gamma [1]; its departure from 1 is also what has been released.
  double ratio(double shear) const { return 1.0 + coefficient * shear; }
};

} // namespace ionskin::laws
