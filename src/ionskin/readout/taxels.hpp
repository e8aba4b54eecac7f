// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/circuits/circuit.hpp"
#include "ionskin/readout/signals.hpp"

#include <string>
#include <vector>

namespace ionskin::readout {

/// Charge on the metal of one part of a segmented top electrode, one entry per row [C].
struct TaxelCharge {
  std::string name;
  std::vector<double> charge;
  /// Charge of the bottom electrode below the taxel: where given, the odd and the even part are
  /// written.
  std::vector<double> bottom_charge{};
  /// Voltage and charge where the taxels have circuits of their own: against the bottom electrode
  /// [V], and the charge that the circuit has passed or holds [C]; empty otherwise.
  std::vector<double> voltage{}, passed{};
};

/// Columns of taxels.csv: time, then current_top_NAME of every taxel (mean over the step that ends
/// at the row), then charge_top_NAME; then of each with a bottom charge current_odd_NAME, half of
/// top minus bottom, and current_even_NAME, half of their sum, and their charges; then of each with
/// a circuit of its own voltage_NAME, current_circuit_NAME and charge_circuit_NAME, and those three
/// of each line of a crossbar.
SignalTable taxel_signals(const std::vector<double>& time, const std::vector<TaxelCharge>& taxels,
                          const std::vector<TaxelCharge>& lines = {});

/// Adds reading_NAME, what the instrument of a taxel shows of the charge that its circuit passes.
void add_reading(const std::string& name, const circuits::InstrumentReading& reading,
                 SignalTable& table);

/// Largest magnitude of the columns of taxels that begin with a prefix, but for those of what is
/// left between them; 0 without such columns.
double largest_of_taxels(const SignalTable& taxels, const std::string& prefix);

/// Largest |current_top_NAME| of any taxel; what is left of the electrode between them is none [A].
double largest_taxel_current(const SignalTable& taxels);

/// True if a taxel, or what is left of the electrode between them, carries any current.
bool carry_current(const SignalTable& taxels);

/// Largest |sum of the taxels' currents - current of the whole electrode| over the peak of the
/// latter; 0 when both vanish.
/// @param current_top of the whole electrode [A]
double taxel_balance_error(const SignalTable& taxels, const std::vector<double>& current_top);

} // namespace ionskin::readout
