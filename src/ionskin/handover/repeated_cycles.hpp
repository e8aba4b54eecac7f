// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/history/core_history.hpp"

#include <cstddef>
#include <functional>
#include <vector>

namespace ionskin::handover {

/// Fills the instants and events of a history with those of a cycle, as often as it is repeated.
/// @param times sample instants of one cycle, from 0 to its duration [s]
/// @param events instants of one cycle, each at a sample up to rounding [s]
/// @param add called for each sample of the history with its place in the cycle; the last sample of
/// a cycle stands for the first of the next
void repeat_cycle(int cycles, const std::vector<double>& times, const std::vector<double>& events,
                  const std::function<void(std::size_t sample)>& add,
                  history::CoreHistory& history);

} // namespace ionskin::handover
