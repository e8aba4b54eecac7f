// SPDX-License-Identifier: Apache-2.0
#include "ionskin/readout/sampling.hpp"

#include "ionskin/base/value_at.hpp"

#include "ionskin/readout/electrode_current.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string_view>
#include <utility>

namespace ionskin::readout {
namespace {

// Tolerance in intervals that keeps the last one when rounding makes the run slightly shorter than
// a whole number of intervals.
constexpr double interval_rounding = 1e-9;

std::vector<double> values_at(const std::vector<double>& time, const std::vector<double>& quantity,
                              const std::vector<double>& instants) {
  std::vector<double> values;
  values.reserve(instants.size());
  for (double instant : instants) {
    values.push_back(base::value_at(time, quantity, instant));
  }
  return values;
}

/// Integrals from the first row to some instants, of a quantity that is linear between the rows.
std::vector<double> integral_at(const std::vector<double>& time,
                                const std::vector<double>& quantity,
                                const std::vector<double>& instants) {
  std::vector<double> result;
  double whole = 0; // integral up to the row before the instant
  std::size_t row = 0;
  for (const double instant : instants) {
    while (row + 1 < time.size() && time[row + 1] <= instant) {
      whole += (time[row + 1] - time[row]) * (quantity[row + 1] + quantity[row]) / 2;
      ++row;
    }
    const double at = base::value_at(time, quantity, instant);
    result.push_back(whole + std::max(0.0, instant - time[row]) * (quantity[row] + at) / 2);
  }
  return result;
}

std::vector<double> rates(const std::vector<double>& instants, const std::vector<double>& values) {
  std::vector<double> result;
  for (std::size_t i = 1; i < instants.size(); ++i) {
    result.push_back((values[i] - values[i - 1]) / (instants[i] - instants[i - 1]));
  }
  return result;
}

// Column of currents without the first row, which has no interval.
Signal interval_means(const std::string& name, const std::vector<double>& currents) {
  return {name, "A", {currents.begin() + 1, currents.end()}};
}

} // namespace

std::vector<double> interval_ends(const std::vector<double>& time, double interval) {
  const double start = time.front();
  const auto count =
      static_cast<std::size_t>(std::floor((time.back() - start) / interval + interval_rounding));
  std::vector<double> instants{start};
  for (std::size_t i = 1; i <= count; ++i) {
    instants.push_back(start + static_cast<double>(i) * interval);
  }
  return instants;
}

SignalTable sample_currents(const SignalTable& signals, double interval,
                            const ChargeRelaxation& relaxation) {
  const std::vector<double>& time = signals.column("time").values;
  const std::vector<double> instants = interval_ends(time, interval);
  std::vector<double> top = values_at(time, signals.column("charge_top").values, instants);
  std::vector<double> bottom = values_at(time, signals.column("charge_bottom").values, instants);
  for (std::size_t i = 0; i < instants.size(); ++i) {
    const double departure = departure_from_line(time, relaxation, instants[i]);
    top[i] += departure;
    bottom[i] -= departure;
  }
  const ElectrodeCurrents means = electrode_currents(instants, top, bottom);
  SignalTable sampled;
  sampled.columns.push_back({"time", "s", {instants.begin() + 1, instants.end()}});
  sampled.columns.push_back(interval_means("current_top", means.top));
  sampled.columns.push_back(interval_means("current_bottom", means.bottom));
  sampled.columns.push_back(interval_means("current_difference", means.difference));
  sampled.columns.push_back(interval_means("current_common", means.common));
  return sampled;
}

SignalTable sample_table(const SignalTable& table, double interval) {
  constexpr std::string_view current = "current";
  const std::vector<double>& time = table.column("time").values;
  const std::vector<double> instants = interval_ends(time, interval);
  SignalTable sampled;
  for (const Signal& column : table.columns) {
    std::vector<double> values;
    if (column.name == "time") {
      values.assign(instants.begin() + 1, instants.end());
    } else if (column.name.starts_with(current)) {
      const Signal& charge = table.column("charge" + column.name.substr(current.size()));
      values = rates(instants, values_at(time, charge.values, instants));
    } else if (column.unit == "C") {
      values = values_at(time, column.values, instants);
      values.erase(values.begin());
    } else {
      values = rates(instants, integral_at(time, column.values, instants));
    }
    sampled.columns.push_back({column.name, column.unit, std::move(values)});
  }
  return sampled;
}

} // namespace ionskin::readout
