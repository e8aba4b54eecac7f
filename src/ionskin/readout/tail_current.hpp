// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/readout/signals.hpp"

#include <vector>

namespace ionskin::readout {

/// For each sampled interval, whether it lies outside the contact spikes: no event in it, and none
/// in the eight relaxation times before it, after which exp(-8) of a spike is left. Where events
/// follow each other faster, half of the longest time between two of them counts instead.
/// @param sampled what `sample_currents` returned for `interval` [s]
/// @param events instants of contact and of changes of phase, ascending [s]
/// @param relaxation_time of the core, lambda^2 / D [s]
std::vector<bool> in_tail(const SignalTable& sampled, double interval,
                          const std::vector<double>& events, double relaxation_time);

/// Root mean square of a sampled current over the intervals outside the spikes; 0 without any [A].
double tail_rms(const std::vector<double>& current, const std::vector<bool>& in_tail);

} // namespace ionskin::readout
