// SPDX-License-Identifier: Apache-2.0
#include "ionskin/handover/repeated_cycles.hpp"

#include <algorithm>

namespace ionskin::handover {

void repeat_cycle(int cycles, const std::vector<double>& times, const std::vector<double>& events,
                  const std::function<void(std::size_t sample)>& add,
                  history::CoreHistory& history) {
  constexpr double rounding = 2e-12; // share of the duration of a cycle
  const double duration = times.back();
  for (int cycle = 0; cycle < cycles; ++cycle) {
    const double offset = cycle * duration;
    for (std::size_t i = cycle == 0 ? 0 : 1; i < times.size(); ++i) {
      history.time.push_back(offset + times[i]);
      add(i);
    }
    for (const double event : events) {
      const double sample =
          *std::ranges::lower_bound(history.time, offset + event - rounding * duration);
      if (history.event_time.empty() || history.event_time.back() < sample) {
        history.event_time.push_back(sample);
      }
    }
  }
}

} // namespace ionskin::handover
