// SPDX-License-Identifier: Apache-2.0
#include "ionskin/readout/circuit.hpp"

#include "ionskin/base/value_at.hpp"
#include "ionskin/readout/electrode_current.hpp"
#include "ionskin/readout/sampling.hpp"

#include <cmath>
#include <cstddef>
#include <utility>

namespace ionskin::readout {
namespace {

/// Distance of a row from the end of an interval within which both count as one, over the interval.
constexpr double same_instant = 1e-6;

} // namespace

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

SampledReading sampled_reading(const circuits::Circuit& circuit, const std::vector<double>& time,
                               const std::vector<double>& charge, double interval) {
  const std::vector<double> ends = interval_ends(time, interval);
  std::vector<double> instants, charges;
  std::vector<std::size_t> of_row, of_end; // indices into the instants
  std::size_t end = 0;
  const auto add = [&](double instant, double value) {
    instants.push_back(instant);
    charges.push_back(value);
  };
  for (std::size_t row = 0; row < time.size(); ++row) {
    for (; end < ends.size() && ends[end] < time[row] - same_instant * interval; ++end) {
      of_end.push_back(instants.size());
      add(ends[end], base::value_at(time, charge, ends[end]));
    }
    of_row.push_back(instants.size());
    if (end < ends.size() && ends[end] <= time[row] + same_instant * interval) {
      of_end.push_back(instants.size());
      ++end;
    }
    add(time[row], charge[row]);
  }
  circuits::InstrumentReading whole = circuit.read(instants, charges);
  SampledReading result;
  for (std::size_t i = 1; i < of_end.size(); ++i) {
    result.mean_current.push_back((whole.charge[of_end[i]] - whole.charge[of_end[i - 1]]) /
                                  interval);
    result.charge.push_back(whole.charge[of_end[i]]);
  }
  for (const std::size_t row : of_row) {
    result.at_rows.current.push_back(whole.current[row]);
    result.at_rows.charge.push_back(whole.charge[row]);
  }
  result.at_rows.figures = std::move(whole.figures);
  result.at_rows.warnings = std::move(whole.warnings);
  return result;
}

SignalTable sampled_instrument_signals(const std::vector<double>& time, double interval,
                                       const SampledReading& reading) {
  const std::vector<double> ends = interval_ends(time, interval);
  SignalTable table;
  table.columns = {{"time", "s", {ends.begin() + 1, ends.end()}},
                   {"current", "A", reading.mean_current},
                   {"charge", "C", reading.charge}};
  return table;
}

} // namespace ionskin::readout
