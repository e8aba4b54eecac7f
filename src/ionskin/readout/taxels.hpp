// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/circuits/circuit.hpp"
#include "ionskin/readout/signals.hpp"

#include <string>
#include <vector>

namespace ionskin::readout {

/// Charge of one taxel, a part of the segmented top electrode, for taxels.csv; or of one line of a
/// crossbar. One entry per row.
struct TaxelCharge {
  std::string name;
  /// Charge on the taxel's metal [C].
  std::vector<double> charge;
  /// Charge of the bottom electrode below the taxel [C]. If not empty, odd and even parts of the
  /// charges are written.
  std::vector<double> bottom_charge{};
  /// Voltage against the bottom electrode [V], and charge that the taxel's own circuit has passed
  /// or holds [C]; empty without such circuits.
  std::vector<double> voltage{}, passed{};
};

/// Makes the table of taxels.csv: time; current_top_NAME of every taxel (mean over the step that
/// ends at the row); charge_top_NAME; for taxels with a bottom charge current_odd_NAME (half of top
/// minus bottom) and charge_odd_NAME, then current_even_NAME (half of their sum) and
/// charge_even_NAME; for taxels with circuits of their own voltage_NAME, current_circuit_NAME and
/// charge_circuit_NAME; and these three for each line of a crossbar.
/// @param time [row] [s]
/// @param lines of a crossbar; empty without one
SignalTable taxel_signals(const std::vector<double>& time, const std::vector<TaxelCharge>& taxels,
                          const std::vector<TaxelCharge>& lines = {});

/// Adds a column reading_NAME with the current that the instrument of a taxel displays.
/// @param name of the taxel or line
/// @param current [row of the table] [A]
void add_reading(const std::string& name, const std::vector<double>& current, SignalTable& table);

/// Largest magnitude in the columns of all taxels whose names begin with a prefix, such as
/// "voltage_"; 0 without such columns. The rest of the electrode between the taxels does not count.
/// @param taxels table of taxels.csv
double largest_of_taxels(const SignalTable& taxels, const std::string& prefix);

/// Largest |current_top_NAME| of any taxel [A]. The rest of the electrode between the taxels does
/// not count.
/// @param taxels table of taxels.csv
double largest_taxel_current(const SignalTable& taxels);

/// True if any taxel, or the rest of the electrode between the taxels, carries current at any row.
bool carry_current(const SignalTable& taxels);

/// Largest |sum of the taxels' currents - current of the whole electrode| over the peak of the
/// electrode's current; 0 when both vanish [1].
/// @param taxels table of taxels.csv
/// @param current_top of the whole electrode [row] [A]
double taxel_balance_error(const SignalTable& taxels, const std::vector<double>& current_top);

} // namespace ionskin::readout
