// SPDX-License-Identifier: Apache-2.0
#include "ionskin/readout/tail_current.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace ionskin::readout {
namespace {

constexpr double spike_duration = 0.05; // [s]

} // namespace

std::vector<bool> in_tail(const SignalTable& sampled, double interval,
                          const std::vector<double>& events) {
  std::vector<bool> result;
  for (const double end : sampled.column("time").values) {
    result.push_back(std::ranges::none_of(events, [&](double event) {
      return event < end && event > end - interval - spike_duration;
    }));
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
