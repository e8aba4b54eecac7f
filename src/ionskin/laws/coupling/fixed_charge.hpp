// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/laws/coupling/coupling_law.hpp"

namespace ionskin::laws {

/// Coupling law `fixed-charge`: shear creates fixed charge in place, docs/model.md (18),
///   cf / c0 = 1 + k gamma.
/// Blocking electrodes keep the mobile ions in the core, so the core gains the net charge
/// F c0 k integral(gamma dV), which the charges of both electrodes together balance at once
/// (Gauss). Source: the law of the skin model that ionskin reproduces (its equation 26).
struct FixedCharge {
  double coefficient = 0; ///< k [1]

  static constexpr CouplingTraits traits{.makes_net_charge = true, .net_charge_is_linear = true};
  static constexpr auto parameters() { return no_parameters<FixedCharge>; }
  /// Ratio cf / c0 [1] at the shear gamma [1].
  double ratio(double shear) const { return 1.0 + coefficient * shear; }
};

} // namespace ionskin::laws
