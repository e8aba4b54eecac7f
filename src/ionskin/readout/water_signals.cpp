// SPDX-License-Identifier: Apache-2.0
#include "ionskin/readout/water_signals.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>

namespace ionskin::readout {
namespace {

template <class Operation>
std::vector<double> combined(const std::vector<double>& first, const std::vector<double>& second,
                             const Operation& operation) {
  std::vector<double> result(first.size());
  std::ranges::transform(first, second, result.begin(), operation);
  return result;
}

} // namespace

SignalTable water_signals(const WaterInputs& inputs) {
  SignalTable table;
  table.columns = {
      {"time", "s", inputs.time},
      {"pore_pressure_top", "Pa", inputs.pressure_top},
      {"pore_pressure_bottom", "Pa", inputs.pressure_bottom},
      {"pressure_difference", "Pa",
       combined(inputs.pressure_top, inputs.pressure_bottom, std::minus<>{})},
      {"streaming_voltage", "V", inputs.streaming_voltage},
      {"dilution_voltage", "V", inputs.dilution_voltage},
      {"open_circuit_voltage", "V",
       combined(inputs.streaming_voltage, inputs.dilution_voltage, std::plus<>{})},
      {"largest_pore_pressure", "Pa", inputs.largest_pressure},
      {"largest_drive", "1", inputs.largest_drive},
      {"water_outflow_top", "m3", inputs.outflow_top},
      {"water_outflow_bottom", "m3", inputs.outflow_bottom},
      {"dragged_outflow_top", "m3", inputs.dragged_top},
      {"dragged_outflow_bottom", "m3", inputs.dragged_bottom},
      {"dragged_pressure_difference", "Pa", inputs.dragged_difference},
  };
  if (peak_magnitude(inputs.holding_pressure) > 0) {
    table.columns.push_back({"holding_pressure", "Pa", inputs.holding_pressure});
  }
  return table;
}

std::vector<Metric> water_metrics(const SignalTable& water, std::optional<double> largest_force,
                                  double area) {
  const auto peak = [&](const char* name) { return peak_magnitude(water.column(name).values); };
  const std::vector<double>& voltage = water.column("open_circuit_voltage").values;
  const auto at = static_cast<std::size_t>(
      std::ranges::max_element(voltage, {}, [](double value) { return std::abs(value); }) -
      voltage.begin());
  std::vector<Metric> metrics{{"peak_open_circuit_voltage", std::abs(voltage[at]), "V"},
                              {"peak_streaming_voltage", peak("streaming_voltage"), "V"},
                              {"peak_dilution_voltage", peak("dilution_voltage"), "V"},
                              {"peak_pressure_difference", peak("pressure_difference"), "Pa"},
                              {"peak_pore_pressure", peak("largest_pore_pressure"), "Pa"},
                              {"peak_drive", peak("largest_drive"), "1"}};
  if (voltage[at] != 0) {
    metrics.push_back(
        {"streaming_share", water.column("streaming_voltage").values[at] / voltage[at], "1"});
  }
  if (largest_force && *largest_force > 0) {
    metrics.push_back(
        {"open_circuit_voltage_per_newton", std::abs(voltage[at]) / *largest_force, "V/N"});
    metrics.push_back(
        {"pressure_asymmetry", peak("pressure_difference") * area / *largest_force, "1"});
  }
  return metrics;
}

} // namespace ionskin::readout
