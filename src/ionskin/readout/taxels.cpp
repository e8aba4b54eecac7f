// SPDX-License-Identifier: Apache-2.0
#include "ionskin/readout/taxels.hpp"

#include "ionskin/readout/electrode_current.hpp"
#include "ionskin/readout/metrics.hpp"

#include <cmath>
#include <cstddef>

namespace ionskin::readout {
namespace {

constexpr const char* current_prefix = "current_top_";

} // namespace

SignalTable taxel_signals(const std::vector<double>& time, const std::vector<TaxelCharge>& taxels) {
  SignalTable table;
  table.columns.push_back({"time", "s", time});
  for (const TaxelCharge& taxel : taxels) {
    table.columns.push_back({current_prefix + taxel.name, "A", step_rates(time, taxel.charge)});
  }
  for (const TaxelCharge& taxel : taxels) {
    table.columns.push_back({"charge_top_" + taxel.name, "C", taxel.charge});
  }
  return table;
}

double taxel_balance_error(const SignalTable& taxels, const std::vector<double>& current_top) {
  std::vector<double> remainder = current_top;
  for (const Signal& column : taxels.columns) {
    if (column.name.starts_with(current_prefix)) {
      for (std::size_t row = 0; row < remainder.size(); ++row) {
        remainder[row] -= column.values[row];
      }
    }
  }
  const double error = peak_magnitude(remainder);
  return error == 0 ? 0 : error / peak_magnitude(current_top);
}

} // namespace ionskin::readout
