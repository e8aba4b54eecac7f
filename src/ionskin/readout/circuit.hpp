// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/circuits/instrument_reading.hpp"
#include "ionskin/readout/signals.hpp"

#include <vector>

namespace ionskin::readout {

// Columns of circuit.csv: voltage, current and charge at the terminals of the readout circuit.

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

} // namespace ionskin::readout
