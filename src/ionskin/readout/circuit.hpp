// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/circuits/circuit.hpp"
#include "ionskin/circuits/instrument_reading.hpp"
#include "ionskin/readout/signals.hpp"

#include <vector>

namespace ionskin::readout {

// Columns of circuit.csv and sampled_circuit.csv: voltage, current and charge at the terminals of
// the readout circuit.

/// Half the difference of the charges of top and bottom electrode, which is the charge that has
/// passed between them [row] [C].
/// @param charge_top, charge_bottom [row] [C]
std::vector<double> charge_difference(const std::vector<double>& charge_top,
                                      const std::vector<double>& charge_bottom);

/// Columns of circuit.csv for a circuit that leaves the potentials free: time, voltage (phi_top -
/// phi_bottom, at the row), current (mean of the difference current over the step that ends at the
/// row), charge (half the difference).
/// @param time [row] [s]
/// @param voltage of the top electrode against the bottom one [row] [V]
/// @param charge as `charge_difference` returns it [row] [C]
SignalTable terminal_signals(const std::vector<double>& time, const std::vector<double>& voltage,
                             const std::vector<double>& charge);

/// Columns of circuit.csv for an instrument: time, current (its reading, at the row), charge
/// (integral of the reading).
/// @param time [row] [s]
SignalTable instrument_signals(const std::vector<double>& time,
                               const circuits::InstrumentReading& reading);

/// Current that a circuit's own instrument shows, at the rows of a run and as means over readout
/// intervals.
struct SampledReading {
  circuits::InstrumentReading at_rows;
  std::vector<double> mean_current; ///< over each interval of `interval_ends` [A]
  std::vector<double> charge;       ///< integral of the shown current, at the ends [C]
};

/// Reads a charge with the instrument of a circuit, which has one. The instrument steps from row to
/// row and to the end of each readout interval: its noise within a long time step is then that of
/// every reading, not a straight line.
/// @param time of the rows [s], ascending
/// @param charge that passes the instrument [row] [C], linear between the rows
/// @param interval readout interval [s], positive
SampledReading sampled_reading(const circuits::Circuit& circuit, const std::vector<double>& time,
                               const std::vector<double>& charge, double interval);

/// Columns of sampled_circuit.csv for an instrument: time (end of each interval), current, charge.
/// @param time of the rows [s]
/// @param interval readout interval [s]
SignalTable sampled_instrument_signals(const std::vector<double>& time, double interval,
                                       const SampledReading& reading);

} // namespace ionskin::readout
