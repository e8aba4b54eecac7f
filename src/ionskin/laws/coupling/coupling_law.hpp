// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/laws/law_parameter.hpp"

#include <cstddef>
#include <functional>
#include <span>
#include <string_view>
#include <vector>

namespace ionskin::laws {

/// Ion grid of the core as a coupling law sees it: nodes in z levels of lateral columns of equal
/// area, with fields as [level][column].
struct CoreLayout {
  std::size_t columns = 0, levels = 0;
  /// Heights of the control volumes [levels], which add up to `thickness`; only their ratio to it
  /// counts.
  std::span<const double> height;
  double thickness = 0; ///< thickness of the core, in the unit of `height`
};

/// Function that computes the fixed charge from the shear: `ratio` receives cf / c0 at each node
/// [level][column] [1] for the `shear` gamma [level][column] [1]. An empty function means that
/// shear does not change the fixed charge.
using Coupling = std::function<void(const CoreLayout& core, std::span<const double> shear,
                                    std::span<double> ratio)>;

/// Properties of a coupling law on which the ion transport solver depends.
struct CouplingTraits {
  bool makes_net_charge = false; ///< shear changes the net charge of the core
  /// True if the net charge is F c0 k integral(gamma), so that Gauss' law can be audited against
  /// the shear.
  bool net_charge_is_linear = false;
  bool releases_ions = false; ///< every fixed charge that shear makes comes with a mobile ion
  /// True if water moves, which drives the cations in addition to the electric potential
  /// (poroelasticity/streaming_drive.hpp).
  bool moves_water = false;
};

/// One row of the table of coupling laws.
struct CouplingLaw {
  std::string_view name; ///< value of the key `coupling.law`
  CouplingTraits traits;
  std::span<const LawParameter> parameters; ///< parameters of its own, beside the coefficient
  /// Creates the law's function from the coupling coefficient k [1] and its own parameters.
  Coupling (*with)(double coefficient, const LawValues& values);
};

/// Table of all coupling laws; the first is the default of a case.
std::span<const CouplingLaw> coupling_laws();

/// Finds a coupling law by its name. Throws InternalError for an unknown name, which the schema has
/// excluded.
const CouplingLaw& coupling_law(std::string_view name);

} // namespace ionskin::laws
