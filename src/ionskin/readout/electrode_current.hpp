// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace ionskin::readout {

/// Currents of the two electrodes, one entry per row [A]. A current is the mean over the step that
/// ends at its row; row 0 has no step, so it is 0 and an initial impulse stands in the charge.
struct ElectrodeCurrents {
  std::vector<double> top, bottom;
  std::vector<double> difference; ///< (top - bottom) / 2: what an ammeter between them carries
  std::vector<double> common;     ///< (top + bottom) / 2: what only a third conductor can supply
};

/// Mean rate of change over the step that ends at each row, 0 in row 0 [unit of `quantity` / s].
/// @param time [s], strictly ascending
std::vector<double> step_rates(const std::vector<double>& time,
                               const std::vector<double>& quantity);

/// I = dQ/dt of each electrode and both parts, docs/model.md (25), (28), exact as means over steps.
/// @param charge_top, charge_bottom charge on the metal [C]
ElectrodeCurrents electrode_currents(const std::vector<double>& time,
                                     const std::vector<double>& charge_top,
                                     const std::vector<double>& charge_bottom);

} // namespace ionskin::readout
