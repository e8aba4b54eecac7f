// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/errors/signal_difference.hpp"

#include "ionskin/base/value_at.hpp"
#include "ionskin/readout/electrode_current.hpp"

#include <cmath>
#include <utility>
#include <vector>

namespace ionskin::study {
namespace {

using readout::Signal;
using readout::SignalTable;

std::vector<double> at_instants(const SignalTable& table, const std::string& column,
                                const std::vector<double>& instants) {
  const std::vector<double>& time = table.column("time").values;
  const std::vector<double>& quantity = table.column(column).values;
  std::vector<double> values;
  for (const double instant : instants) {
    values.push_back(base::value_at(time, quantity, instant));
  }
  return values;
}

/// Root of the sum of squares, each row weighted by the time step that ends there; NaN is skipped.
double norm(const std::vector<double>& time, const std::vector<double>& values) {
  double sum = 0;
  for (std::size_t row = 1; row < time.size(); ++row) {
    if (!std::isnan(values[row])) {
      sum += values[row] * values[row] * (time[row] - time[row - 1]);
    }
  }
  return std::sqrt(sum);
}

/// Interpolates the signals of a solution to the instants of a reference table.
SignalTable on_steps(const SignalTable& reference, const SignalTable& table) {
  const std::vector<double>& time = reference.column("time").values;
  SignalTable result;
  for (const Signal& column : reference.columns) {
    result.columns.push_back(
        {column.name, column.unit,
         column.name == "time" ? time : at_instants(table, column.name, time)});
  }
  return result;
}

void take_rates(SignalTable& table) {
  const std::vector<double> time = table.column("time").values;
  const auto currents = readout::electrode_currents(time, table.column("charge_top").values,
                                                    table.column("charge_bottom").values);
  const auto rate = readout::step_rates(time, table.column("mean_shear").values);
  const std::map<std::string, const std::vector<double>*> rates{
      {"current_top", &currents.top},
      {"current_bottom", &currents.bottom},
      {"current_difference", &currents.difference},
      {"current_common", &currents.common},
      {"mean_shear_rate", &rate}};
  for (Signal& column : table.columns) {
    if (const auto found = rates.find(column.name); found != rates.end()) {
      column.values = *found->second;
    }
  }
}

TableDifference subtract(const SignalTable& first, const SignalTable& second) {
  TableDifference result;
  const std::vector<double>& time = first.column("time").values;
  for (std::size_t i = 0; i < first.columns.size(); ++i) {
    Signal difference = first.columns[i];
    if (difference.name != "time") {
      for (std::size_t row = 0; row < time.size(); ++row) {
        difference.values[row] = second.columns[i].values[row] - first.columns[i].values[row];
      }
      const double size = norm(time, first.columns[i].values);
      result.relative_norm[difference.name] = size > 0 ? norm(time, difference.values) / size : 0.0;
    }
    result.table.columns.push_back(std::move(difference));
  }
  return result;
}

} // namespace

TableDifference table_difference(const SignalTable& reference, const SignalTable& first,
                                 const SignalTable& second) {
  return subtract(on_steps(reference, first), on_steps(reference, second));
}

TableDifference resolved_difference(const SignalTable& reference, const Signals& first,
                                    const Signals& second) {
  SignalTable one = on_steps(reference, first.resolved), two = on_steps(reference, second.resolved);
  take_rates(one);
  take_rates(two);
  return subtract(one, two);
}

} // namespace ionskin::study
