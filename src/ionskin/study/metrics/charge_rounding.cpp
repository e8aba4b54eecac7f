// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/metrics/charge_rounding.hpp"

#include "ionskin/electrochemistry/coupling/driving_channel.hpp"
#include "ionskin/history/shear_statistics.hpp"

#include <algorithm>
#include <cmath>

namespace ionskin::study {
namespace {

constexpr double part_of_charge = 5e-11;

} // namespace

double charge_rounding(const Case& input, const history::CoreHistory& history) {
  const history::HistoryChannel& channel =
      electrochemistry::driving_channel(input.coupling.law, history);
  double largest = 0;
  for (const double time : history.time) {
    largest = std::max(largest, history::channel_integrals(history, channel, time).magnitude);
  }
  return part_of_charge *
         (std::abs(electrochemistry::charge_density_of_channel(input, channel)) * largest +
          electrochemistry::charge_moved_by_outside_water(input));
}

} // namespace ionskin::study
