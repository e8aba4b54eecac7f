// SPDX-License-Identifier: Apache-2.0
#include "ionskin/readout/charge_relaxation.hpp"

#include <algorithm>
#include <cstddef>

namespace ionskin::readout {

double departure_from_line(const std::vector<double>& time, const ChargeRelaxation& relaxation,
                           double instant) {
  const auto after = std::upper_bound(time.begin(), time.end(), instant);
  if (relaxation.charge.empty() || after == time.begin() || after == time.end()) {
    return 0;
  }
  const auto i = static_cast<std::size_t>(after - time.begin());
  const double step = time[i] - time[i - 1];
  const double weight = (instant - time[i - 1]) / step;
  const double slope = (relaxation.charge[i] - relaxation.charge[i - 1]) / step;
  return step * weight * (1 - weight) *
         ((1 - weight) * (relaxation.current[i - 1] - slope) -
          weight * (relaxation.current[i] - slope));
}

} // namespace ionskin::readout
