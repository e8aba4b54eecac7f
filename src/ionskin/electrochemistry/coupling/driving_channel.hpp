// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/history/core_history.hpp"
#include "ionskin/laws/coupling/coupling_law.hpp"

#include <string>
#include <vector>

namespace ionskin::electrochemistry {

/// Names of the history channels that can drive a coupling law, in order of preference.
std::vector<std::string> channels_for(const laws::CouplingLaw& law);

/// Finds the channel of a strain history that drives a coupling law: the first of `channels_for`
/// that the history has. Throws InternalError when it has none.
/// @param law name of the coupling law
const history::HistoryChannel& driving_channel(const std::string& law,
                                               const history::CoreHistory& history);

/// Charge per volume that a unit of the channel moves or makes in the core, to first order [C/m3
/// per unit of the channel].
double charge_density_of_channel(const Case& input, const history::HistoryChannel& channel);

/// Charge that water under pressure outside the walls moves in the core, to first order [C]; 0
/// without such pressure.
double charge_moved_by_outside_water(const Case& input);

} // namespace ionskin::electrochemistry
