// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/laws/coupling/coupling_law.hpp"

namespace ionskin::laws {

/// Coupling law `pair-generation`: shear dissociates pairs, so that every fixed charge comes with a
/// mobile ion released at the same place, docs/model.md (21),
///   cf / c0 = 1 + k gamma,   source of v c / c0 = d(k gamma)/dt.
/// The core stays neutral as a whole: the charges of the electrodes add up to zero, and the
/// integral of v c equals the integral of cf at all times. The current is driven by diffusion of
/// the released ions away from their fixed partners. Where shear decreases, pairs recombine.
/// Source: the `fixed-charge` law made to conserve charge, as a dissociation reaction demands.
struct PairGeneration {
  double coefficient = 0; ///< k [1]

  static constexpr CouplingTraits traits{.releases_ions = true};
  static constexpr auto parameters() { return no_parameters<PairGeneration>; }
  /// Ratio cf / c0 [1] at the shear gamma [1]; ratio - 1 is also the concentration of released
  /// ions, v c over c0.
  double ratio(double shear) const { return 1.0 + coefficient * shear; }
};

} // namespace ionskin::laws
