// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/circuits/instrument_reading.hpp"
#include "ionskin/readout/signals.hpp"

#include <vector>

namespace ionskin::readout {

// Columns of circuit.csv: what stands at the terminals of the readout circuit.

/// Half the difference of the electrodes' charges: the charge that has passed between them [C].
std::vector<double> charge_difference(const std::vector<double>& charge_top,
                                      const std::vector<double>& charge_bottom);

/// Circuits that leave the potentials free: time, voltage (phi_top - phi_bottom, at the row),
/// current (difference current, mean over the step that ends at the row) and charge (difference
/// charge).
SignalTable terminal_signals(const std::vector<double>& time, const std::vector<double>& voltage,
                             const std::vector<double>& charge);

/// Instrument: time, current (its reading, at the row) and charge (integral of the reading).
SignalTable instrument_signals(const std::vector<double>& time,
                               const circuits::InstrumentReading& reading);

} // namespace ionskin::readout
