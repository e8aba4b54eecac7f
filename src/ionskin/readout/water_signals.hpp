// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/readout/metrics.hpp"
#include "ionskin/readout/signals.hpp"

#include <optional>
#include <vector>

namespace ionskin::readout {

/// Quantities of the water in the core for water.csv, one entry per row.
struct WaterInputs {
  std::vector<double> time; ///< [s]
  /// Pore pressure P at the walls, means over their areas, docs/model.md (22) [Pa].
  std::vector<double> pressure_top, pressure_bottom;
  /// The two parts of the open-circuit voltage [V].
  std::vector<double> streaming_voltage, dilution_voltage;
  std::vector<double> largest_pressure; ///< largest magnitude of the pore pressure in the core [Pa]
  /// Largest magnitude of g of docs/model.md (23) in the core [1].
  std::vector<double> largest_drive;
  /// Water that has left through each wall since the first row, and the part that the ionic current
  /// has dragged [m3].
  std::vector<double> outflow_top, outflow_bottom, dragged_top, dragged_bottom;
  /// Difference of the pore pressure between top and bottom wall that the dragged water makes [Pa].
  std::vector<double> dragged_difference;
  /// Pressure on the faces under a prescribed compression, else 0 [Pa].
  std::vector<double> holding_pressure;
};

/// Makes the table of water.csv: time, pore_pressure_top, pore_pressure_bottom, pressure_difference
/// (top minus bottom), streaming_voltage, dilution_voltage, open_circuit_voltage (their sum),
/// largest_pore_pressure, largest_drive; water_outflow_top and _bottom (water that left through the
/// walls), dragged_outflow_top and _bottom (the part dragged by the current),
/// dragged_pressure_difference; and holding_pressure if a compression is held.
SignalTable water_signals(const WaterInputs& inputs);

/// Computes peaks of the columns of water.csv, and the streaming share of the voltage where the
/// open-circuit voltage is largest; with a force also voltage and pressure per force.
/// @param water table of water.csv
/// @param largest_force largest normal force of the run [N]; empty without contact
/// @param area of the skin [m2]
std::vector<Metric> water_metrics(const SignalTable& water, std::optional<double> largest_force,
                                  double area);

} // namespace ionskin::readout
