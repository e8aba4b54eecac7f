// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace ionskin::readout {

/// Currents of the two electrodes [row] [A]. Each value is the mean over the step that ends at the
/// row; row 0 has no step and is 0, so that an initial impulse appears in the charge only.
struct ElectrodeCurrents {
  std::vector<double> top, bottom;
  /// (top - bottom) / 2: current of an ammeter between the electrodes.
  std::vector<double> difference;
  std::vector<double> common; ///< (top + bottom) / 2: only a third conductor can supply it
};

/// Mean rate of change of a quantity over the step that ends at each row; 0 in row 0, or NaN if the
/// quantity is NaN there [row] [unit of `quantity` / s].
/// @param time [row] [s], strictly ascending
/// @param quantity [row]
std::vector<double> step_rates(const std::vector<double>& time,
                               const std::vector<double>& quantity);

/// Computes the current I = dQ/dt of each electrode, and its difference and common part, as exact
/// means over steps, docs/model.md (25), (28).
/// @param time [row] [s], strictly ascending
/// @param charge_top, charge_bottom charge on the metal [row] [C]
ElectrodeCurrents electrode_currents(const std::vector<double>& time,
                                     const std::vector<double>& charge_top,
                                     const std::vector<double>& charge_bottom);

} // namespace ionskin::readout
