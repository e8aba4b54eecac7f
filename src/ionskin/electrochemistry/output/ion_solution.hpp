// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace ionskin::electrochemistry {

/// Columns in x and y (edges), nodes in z from 0 at the bottom of the core. All [m].
struct TransportGrid {
  std::vector<double> x_edges, y_edges, z_nodes;
};

/// Concentration and potential at one instant, [z][y][x] with x fastest.
struct IonSnapshot {
  double time = 0;                   ///< [s]
  std::vector<double> concentration; ///< [mol/m3]
  std::vector<double> potential;     ///< [V]
  std::vector<double> shear;         ///< on the transport grid [1]
  // Pressure and swelling under laws that move water, empty otherwise.
  std::vector<double> pore_pressure; ///< P [Pa]
  std::vector<double> swelling;      ///< (P - p_u)/M, of the water that has come [1]
};

/// Charge on the metal of one part of the top electrode, and of the bottom one below it, one entry
/// per row [C]; or that on a line of a crossbar, on its own face.
struct SegmentCharge {
  std::string name;
  std::vector<double> charge, bottom_charge;
  // Voltage and charge of taxels with circuits of their own: against the bottom electrode, and the
  // charge that the circuit has passed or holds, without the part that returns through the ground.
  // Empty otherwise. Of a crossing the voltage is that of its column against its row, and the
  // charge what the column has passed while a scan read the row; of a line against the ground.
  std::vector<double> voltage; ///< [V]
  std::vector<double> passed;  ///< [C]
  /// Charge that came and went while the taxel of a scan was not read [C].
  std::vector<double> bypassed;
};

/// Where the water stands, of laws that move it: one entry per row, empty otherwise.
struct WaterRows {
  std::vector<double> pressure_top, pressure_bottom; ///< P at the walls, means over the area [Pa]
  /// Parts of the voltage that the open cell would have at once, were its core many Debye lengths
  /// thick: by water that drags cations, and by their dilution [V].
  std::vector<double> streaming_voltage, dilution_voltage;
  std::vector<double> largest_pressure; ///< largest |P| in the core [Pa]
  std::vector<double> largest_drive;    ///< largest |g| in the core [thermal voltages over v]
  /// Water that has left through each wall since the first row, and of it what the ionic current
  /// has dragged [m3].
  std::vector<double> outflow_top, outflow_bottom, dragged_top, dragged_bottom;
  /// P at the top wall above that at the bottom one that the dragged water makes, and that does not
  /// act on the ions, means over the area [Pa].
  std::vector<double> dragged_difference;
  std::vector<double> holding_pressure; ///< on the faces, of a compression that is held [Pa]
};

/// All of Study 2. Row 0 is the initial state with the response to a shear that does not start at
/// 0.
struct IonSolution {
  TransportGrid grid;
  // One entry per time step [rows].
  std::vector<double> time; ///< [s]
  /// Charge on the metal [C]: residual of Poisson's equation at each wall, summed over the columns.
  std::vector<double> charge_top, charge_bottom;
  /// Charge of the top electrode by the volume formula of Ramo and Shockley [rows], docs/model.md
  /// (27) [C].
  std::vector<double> ramo_charge_top;
  /// The part of half the difference of the charges that changes smoothly at kinks of the shear,
  /// and its rate [C], [A]: the ions' part at given potentials, all of it behind a circuit. The
  /// rest follows the shear linearly between the rows.
  std::vector<double> relaxation_charge, relaxation_current;
  std::vector<double> voltage; ///< of the top electrode against the bottom one [V]
  /// Largest difference in potential along the metal of either electrode [V]; empty where it has no
  /// sheet resistance.
  std::vector<double> metal_drop;
  std::vector<double> ion_amount;        ///< integral of c [mol]
  std::vector<double> min_concentration; ///< [mol/m3]
  std::vector<double> max_potential;     ///< largest |phi| [V]
  std::vector<double> shear_integral;    ///< of gamma on the transport grid [m3]
  WaterRows water;
  std::optional<double> taxel_crosstalk; ///< see `taxel_crosstalk`; with circuits of their own only
  std::vector<SegmentCharge> top_segments; ///< the taxels and the rest; empty without taxels
  std::vector<SegmentCharge> lines;        ///< of a crossbar, see Readout::lines
  /// Charge of the top wall per column at the last row [C], [y][x].
  std::vector<double> column_charge_top;
  std::vector<IonSnapshot> snapshots;
  // counters
  std::size_t steps = 0, rejected_steps = 0, residual_evaluations = 0, krylov_iterations = 0,
              preconditioner_setups = 0;
};

} // namespace ionskin::electrochemistry
