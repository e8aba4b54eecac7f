// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/history/core_history.hpp"

#include <cstddef>
#include <functional>
#include <vector>

namespace ionskin::handover {

/// Fills the instants and events of a strain history by repeating one cycle.
/// @param cycles number of repetitions
/// @param times sample instants of one cycle, from 0 to its duration [s]
/// @param events event instants of one cycle, each equal to a sample but for rounding [s]
/// @param add called for each new sample of the history with the index of the sample in `times`.
/// The last sample of a cycle also serves as the first of the next.
/// @param history whose `time` and `event_time` are filled
void repeat_cycle(int cycles, const std::vector<double>& times, const std::vector<double>& events,
                  const std::function<void(std::size_t sample)>& add,
                  history::CoreHistory& history);

} // namespace ionskin::handover
