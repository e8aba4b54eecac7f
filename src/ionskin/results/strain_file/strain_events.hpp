// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/history/core_history.hpp"

#include <vector>

namespace ionskin::results {

/// Events of a history that does not name its own. The first sample is always one. An inner sample
/// is one when the rate of a channel jumps there by more than 1e-3 of the largest rate of the
/// history, both as volume integrals of magnitudes over the history's own cells, or when the
/// slider's velocity jumps by more than 1e-3 of its largest speed while a channel is not zero.
/// Smaller jumps are left to the error control of the time steps.
/// @return instants [s], a subset of `history.time`
std::vector<double> detect_events(const history::CoreHistory& history);

} // namespace ionskin::results
