// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/laws/coupling/coupling_law.hpp"

namespace ionskin::laws {

/// Coupling law `column-neutral`: shear moves fixed charge through the thickness only,
/// docs/model.md (20),
///   cf / c0 = 1 + k (gamma - mean of gamma through the thickness at the same x, y).
/// The fixed charge of every lateral column is conserved, so the two electrodes carry opposite
/// charges everywhere. Source: the charge-neutral reading of the `fixed-charge` law, for a core
/// that is thin compared with lengths along it.
struct ColumnNeutral {
  double coefficient = 0; ///< k [1]

  static constexpr CouplingTraits traits{};
  static constexpr auto parameters() { return no_parameters<ColumnNeutral>; }
  /// Computes cf / c0 from the shear gamma, each [level][column] [1].
  void apply(const CoreLayout& core, std::span<const double> shear, std::span<double> ratio) const;
};

} // namespace ionskin::laws
