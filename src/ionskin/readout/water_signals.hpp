// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/readout/metrics.hpp"
#include "ionskin/readout/signals.hpp"

#include <optional>
#include <vector>

namespace ionskin::readout {

/// Values of the water, one entry per row.
struct WaterInputs {
  std::vector<double> time;                                ///< [s]
  std::vector<double> pressure_top, pressure_bottom;       ///< means over the walls [Pa]
  std::vector<double> streaming_voltage, dilution_voltage; ///< of the open cell [V]
  std::vector<double> largest_pressure;                    ///< in the core [Pa]
  std::vector<double> largest_drive;                       ///< in the core [1]
  /// Water that left since the first row, all of it and what the current has dragged [m3].
  std::vector<double> outflow_top, outflow_bottom, dragged_top, dragged_bottom;
  std::vector<double> dragged_difference; ///< of the pressure at the walls [Pa]
  std::vector<double> holding_pressure;   ///< of a prescribed compression, else 0 [Pa]
};

/// Columns of water.csv: time, pore_pressure_top, pore_pressure_bottom, pressure_difference (top
/// minus bottom), streaming_voltage, dilution_voltage, open_circuit_voltage (their sum),
/// largest_pore_pressure, largest_drive; water_outflow_top and _bottom, which has left through the
/// walls, dragged_outflow_top and _bottom, what the current has dragged of it,
/// dragged_pressure_difference, and of a compression that is held, holding_pressure.
SignalTable water_signals(const WaterInputs& inputs);

/// Peaks of them, and the share of streaming where the open-circuit voltage is largest; with a
/// force also pressure and voltage over it.
/// @param largest_force normal, over the run [N]; empty without contact
/// @param area of the skin [m2]
std::vector<Metric> water_metrics(const SignalTable& water, std::optional<double> largest_force,
                                  double area);

} // namespace ionskin::readout
