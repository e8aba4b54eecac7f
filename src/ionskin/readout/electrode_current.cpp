// SPDX-License-Identifier: Apache-2.0
#include "ionskin/readout/electrode_current.hpp"

#include <cmath>
#include <cstddef>

namespace ionskin::readout {

std::vector<double> step_rates(const std::vector<double>& time,
                               const std::vector<double>& quantity) {
  std::vector<double> rates(time.size(), 0.0);
  if (!quantity.empty() && std::isnan(quantity.front())) {
    rates.front() = quantity.front(); // an empty entry has no rate
  }
  for (std::size_t row = 1; row < time.size(); ++row) {
    rates[row] = (quantity[row] - quantity[row - 1]) / (time[row] - time[row - 1]);
  }
  return rates;
}

ElectrodeCurrents electrode_currents(const std::vector<double>& time,
                                     const std::vector<double>& charge_top,
                                     const std::vector<double>& charge_bottom) {
  ElectrodeCurrents currents;
  currents.top = step_rates(time, charge_top);
  currents.bottom = step_rates(time, charge_bottom);
  for (std::size_t row = 0; row < time.size(); ++row) {
    currents.difference.push_back(0.5 * (currents.top[row] - currents.bottom[row]));
    currents.common.push_back(0.5 * (currents.top[row] + currents.bottom[row]));
  }
  return currents;
}

} // namespace ionskin::readout
