// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/electrochemistry/grid/scaled_grid.hpp"
#include "ionskin/history/core_history.hpp"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ionskin::electrochemistry {

/// One row of the table of coupling laws: the name that a case gives in `coupling.law`, and what
/// the law does.
struct CouplingLaw {
  std::string_view name;
  /// Fixed charge from shear: `ratio` receives cf / c0 per control volume. Null where shear leaves
  /// the fixed charge as it is.
  void (*apply)(double coefficient, const ScaledGrid& grid, std::span<const double> shear,
                std::span<double> ratio);
  bool makes_net_charge = false; ///< the core's charge changes with the shear
  bool releases_ions = false;    ///< a mobile ion comes with every fixed charge
  /// Moves water, which drives the cations beside the potential (poroelasticity/streaming_drive).
  bool moves_water = false;

  /// Channels that can drive the law, the first that a history has does.
  std::vector<std::string> channels() const;
  /// The channel of a history that drives the law, which must be there.
  const history::HistoryChannel& channel(const history::CoreHistory& history) const;
};

/// Charge that a unit of the law's channel moves or makes per volume, to first order
/// [C/m3 per unit of the channel].
double charge_density_of_channel(const Case& input, const history::HistoryChannel& channel);

/// The law of a name that the schema has checked.
const CouplingLaw& coupling_law(const std::string& name);

} // namespace ionskin::electrochemistry
