// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/readout/amplifier.hpp"
#include "ionskin/readout/signals.hpp"

#include <vector>

namespace ionskin::readout {

// Columns of circuit.csv: what stands at the terminals of the readout circuit.

/// Half the difference of the electrodes' charges: what has passed between them [C].
std::vector<double> charge_difference(const std::vector<double>& charge_top,
                                      const std::vector<double>& charge_bottom);

/// Open circuit and load: time, voltage (phi_top - phi_bottom, at the row), current (difference
/// current, mean over the step that ends at the row) and charge (difference charge).
SignalTable terminal_signals(const std::vector<double>& time, const std::vector<double>& voltage,
                             const std::vector<double>& charge);

/// Amplifier: time, current (its reading, at the row) and charge (integral of the reading).
SignalTable amplifier_signals(const std::vector<double>& time, const AmplifierReading& reading);

} // namespace ionskin::readout
