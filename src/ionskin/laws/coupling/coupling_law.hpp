// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/laws/law_parameter.hpp"

#include <cstddef>
#include <functional>
#include <span>
#include <string_view>
#include <vector>

namespace ionskin::laws {

/// The core as a coupling law sees it: nodes in levels, [level][column], and the share of each
/// level's control volume in a column.
struct CoreLayout {
  std::size_t columns = 0, levels = 0;
  std::span<const double> height; ///< of the control volumes [levels]; they add up to `thickness`
  double thickness = 0;
};

/// Fixed charge from shear: `ratio` receives cf / c0 per node [1]. Empty where shear leaves the
/// fixed charge as it is.
using Coupling = std::function<void(const CoreLayout& core, std::span<const double> shear,
                                    std::span<double> ratio)>;

/// Traits of a law: what it does to the charge of the core.
struct CouplingTraits {
  bool makes_net_charge = false; ///< the core's charge changes with the shear
  /// The net charge is F c0 k integral(gamma): Gauss' law can be audited against the shear.
  bool net_charge_is_linear = false;
  bool releases_ions = false; ///< a mobile ion comes with every fixed charge
  /// Moves water, which drives the cations beside the potential (poroelasticity/streaming_drive).
  bool moves_water = false;
};

/// One row of the table of coupling laws.
struct CouplingLaw {
  std::string_view name; ///< value of `coupling.law`
  CouplingTraits traits;
  std::span<const LawParameter> parameters;
  Coupling (*with)(double coefficient, const LawValues& values);
};

/// All laws; the first is the default of a case.
std::span<const CouplingLaw> coupling_laws();

/// The law of a name that the schema has checked.
const CouplingLaw& coupling_law(std::string_view name);

} // namespace ionskin::laws
