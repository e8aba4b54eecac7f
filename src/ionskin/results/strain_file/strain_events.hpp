// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/history/core_history.hpp"

#include <vector>

namespace ionskin::results {

/// Finds the events of a strain history that does not list its own: instants at which the time
/// integration of the ions restarts with a small step. The first sample is always an event. An
/// inner sample is an event when the rate of a strain channel jumps by more than 1e-3 of the
/// largest rate of that channel (both as the integral of the magnitude over the grid), or when the
/// slider's velocity along x or y jumps by more than 1e-3 of its largest magnitude while a channel
/// is not zero. The error control of the time steps handles smaller jumps.
/// @return instants of the events [s], a subset of `history.time`
std::vector<double> detect_events(const history::CoreHistory& history);

} // namespace ionskin::results
