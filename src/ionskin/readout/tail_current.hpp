// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/readout/signals.hpp"

#include <vector>

namespace ionskin::readout {

/// Finds the readout intervals outside the current spikes of contact events. Such an interval
/// contains no event, nor do the eight relaxation times before it, after which exp(-8) of a spike
/// is left. Where events follow each other faster, half of the longest time between two events is
/// used instead.
/// @param sampled table that `sample_currents` returned for `interval`
/// @param interval readout interval [s]
/// @param events instants of contact and of changes of phase, ascending [s]
/// @param relaxation_time of the core, lambda^2 / D [s]
/// @returns true for intervals outside the spikes [row of `sampled`]
std::vector<bool> in_tail(const SignalTable& sampled, double interval,
                          const std::vector<double>& events, double relaxation_time);

/// Root mean square of a sampled current over the intervals outside the spikes; 0 if there is none
/// [A].
/// @param current [interval] [A]
/// @param in_tail as the function `in_tail` returns it [interval]
double tail_rms(const std::vector<double>& current, const std::vector<bool>& in_tail);

} // namespace ionskin::readout
