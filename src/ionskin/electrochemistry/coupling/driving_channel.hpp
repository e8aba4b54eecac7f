// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/history/core_history.hpp"
#include "ionskin/laws/coupling/coupling_law.hpp"

#include <string>
#include <vector>

namespace ionskin::electrochemistry {

/// Channels that can drive a law, the first that a history has does.
std::vector<std::string> channels_for(const laws::CouplingLaw& law);

/// The channel of a history that drives a coupling law, given by its name. Throws InternalError
/// where it has none.
const history::HistoryChannel& driving_channel(const std::string& law,
                                               const history::CoreHistory& history);

/// Charge that a unit of the channel moves or makes per volume, to first order
/// [C/m3 per unit of the channel].
double charge_density_of_channel(const Case& input, const history::HistoryChannel& channel);

/// Charge that water under pressure outside the walls moves in the core, to first order; 0 where
/// there is none [C].
double charge_moved_by_outside_water(const Case& input);

} // namespace ionskin::electrochemistry
