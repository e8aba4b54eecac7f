// SPDX-License-Identifier: Apache-2.0
#include "ionskin/readout/circuit.hpp"

#include "ionskin/readout/electrode_current.hpp"

#include <cstddef>

namespace ionskin::readout {

std::vector<double> charge_difference(const std::vector<double>& charge_top,
                                      const std::vector<double>& charge_bottom) {
  std::vector<double> difference(charge_top.size());
  for (std::size_t row = 0; row < difference.size(); ++row) {
    difference[row] = 0.5 * (charge_top[row] - charge_bottom[row]);
  }
  return difference;
}

SignalTable terminal_signals(const std::vector<double>& time, const std::vector<double>& voltage,
                             const std::vector<double>& charge) {
  SignalTable table;
  table.columns = {{"time", "s", time},
                   {"voltage", "V", voltage},
                   {"current", "A", step_rates(time, charge)},
                   {"charge", "C", charge}};
  return table;
}

SignalTable instrument_signals(const std::vector<double>& time,
                               const circuits::InstrumentReading& reading) {
  SignalTable table;
  table.columns = {
      {"time", "s", time}, {"current", "A", reading.current}, {"charge", "C", reading.charge}};
  return table;
}

} // namespace ionskin::readout
