// SPDX-License-Identifier: Apache-2.0
#include "ionskin/readout/tail_current.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace ionskin::readout {
namespace {

constexpr double spike_relaxations = 8;

/// Duration after an event for which its spike hides the tail of the current [s].
double spike_duration(const std::vector<double>& events, double relaxation_time) {
  double longest = 0;
  for (std::size_t i = 1; i < events.size(); ++i) {
    longest = std::max(longest, events[i] - events[i - 1]);
  }
  const double spike = spike_relaxations * relaxation_time;
  return longest > 0 ? std::min(spike, 0.5 * longest) : spike;
}

} // namespace

std::vector<bool> in_tail(const SignalTable& sampled, double interval,
                          const std::vector<double>& events, double relaxation_time) {
  const double spike = spike_duration(events, relaxation_time);
  std::vector<bool> result;
  for (const double end : sampled.column("time").values) {
    result.push_back(std::ranges::none_of(
        events, [&](double event) { return event < end && event > end - interval - spike; }));
  }
  return result;
}

double tail_rms(const std::vector<double>& current, const std::vector<bool>& in_tail) {
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < current.size(); ++i) {
    if (in_tail[i]) {
      sum += current[i] * current[i];
      ++count;
    }
  }
  return count == 0 ? 0 : std::sqrt(sum / static_cast<double>(count));
}

} // namespace ionskin::readout
