// SPDX-License-Identifier: Apache-2.0
#include "ionskin/readout/taxels.hpp"

#include "ionskin/readout/electrode_current.hpp"
#include "ionskin/readout/metrics.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

namespace ionskin::readout {
namespace {

constexpr const char* current_prefix = "current_top_";
constexpr const char* rest_name = "rest"; // part of the electrode that no taxel covers

void add_circuits(const std::vector<double>& time, const std::vector<TaxelCharge>& taxels,
                  SignalTable& table) {
  for (const TaxelCharge& taxel : taxels) {
    if (!taxel.voltage.empty()) {
      table.columns.push_back({"voltage_" + taxel.name, "V", taxel.voltage});
    }
  }
  for (const TaxelCharge& taxel : taxels) {
    if (!taxel.passed.empty()) {
      table.columns.push_back(
          {"current_circuit_" + taxel.name, "A", step_rates(time, taxel.passed)});
    }
  }
  for (const TaxelCharge& taxel : taxels) {
    if (!taxel.passed.empty()) {
      table.columns.push_back({"charge_circuit_" + taxel.name, "C", taxel.passed});
    }
  }
}

/// Adds columns for half of the top charges plus `sign` times the bottom charges: currents of all
/// taxels, then charges.
void add_part(const std::vector<double>& time, const std::vector<TaxelCharge>& taxels,
              const std::string& part, double sign, SignalTable& table) {
  std::vector<Signal> charges;
  for (const TaxelCharge& taxel : taxels) {
    if (taxel.bottom_charge.empty()) {
      continue;
    }
    std::vector<double> charge = taxel.charge;
    for (std::size_t row = 0; row < charge.size(); ++row) {
      charge[row] = 0.5 * (charge[row] + sign * taxel.bottom_charge[row]);
    }
    table.columns.push_back({"current_" + part + "_" + taxel.name, "A", step_rates(time, charge)});
    charges.push_back({"charge_" + part + "_" + taxel.name, "C", std::move(charge)});
  }
  for (Signal& charge : charges) {
    table.columns.push_back(std::move(charge));
  }
}

} // namespace

SignalTable taxel_signals(const std::vector<double>& time, const std::vector<TaxelCharge>& taxels,
                          const std::vector<TaxelCharge>& lines) {
  SignalTable table;
  table.columns.push_back({"time", "s", time});
  for (const TaxelCharge& taxel : taxels) {
    table.columns.push_back({current_prefix + taxel.name, "A", step_rates(time, taxel.charge)});
  }
  for (const TaxelCharge& taxel : taxels) {
    table.columns.push_back({"charge_top_" + taxel.name, "C", taxel.charge});
  }
  for (const auto& [part, sign] : {std::pair{"odd", -1.0}, {"even", 1.0}}) {
    add_part(time, taxels, part, sign, table);
  }
  add_circuits(time, taxels, table);
  add_circuits(time, lines, table);
  return table;
}

void add_reading(const std::string& name, const std::vector<double>& current, SignalTable& table) {
  table.columns.push_back({"reading_" + name, "A", current});
}

double largest_taxel_current(const SignalTable& taxels) {
  return largest_of_taxels(taxels, current_prefix);
}

double largest_of_taxels(const SignalTable& taxels, const std::string& prefix) {
  const std::string current = current_prefix;
  double largest = 0;
  for (const Signal& taxel : taxels.columns) {
    if (!taxel.name.starts_with(current) || taxel.name == current + rest_name) {
      continue;
    }
    const std::string name = prefix + taxel.name.substr(current.size());
    for (const Signal& column : taxels.columns) {
      if (column.name == name) {
        largest = std::fmax(largest, peak_magnitude(column.values));
      }
    }
  }
  return largest;
}

bool carry_current(const SignalTable& taxels) {
  return std::ranges::any_of(taxels.columns, [](const Signal& column) {
    return column.name.starts_with(current_prefix) && peak_magnitude(column.values) > 0;
  });
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
