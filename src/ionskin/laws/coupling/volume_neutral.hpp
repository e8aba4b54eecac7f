// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/laws/coupling/coupling_law.hpp"

namespace ionskin::laws {

/// Coupling law `volume-neutral`: shear moves fixed charge within the core, docs/model.md (19),
///   cf / c0 = 1 + k (gamma - mean of gamma over the core).
/// The total fixed charge is conserved: the mean of cf over the core stays c0, so the two
/// electrodes carry opposite charges. Source: the charge-neutral reading of the `fixed-charge` law,
/// as electroneutrality of an isolated core demands (Gauss).
struct VolumeNeutral {
  double coefficient = 0; ///< k [1]

  static constexpr CouplingTraits traits{};
  static constexpr auto parameters() { return no_parameters<VolumeNeutral>; }
  /// Computes cf / c0 from the shear gamma, each [level][column] [1].
  void apply(const CoreLayout& core, std::span<const double> shear, std::span<double> ratio) const;
};

} // namespace ionskin::laws
