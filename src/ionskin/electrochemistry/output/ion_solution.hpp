// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace ionskin::electrochemistry {

/// Grid of the ion transport solver: edges of the lateral columns in x and y, nodes in z measured
/// from the bottom of the core [m].
struct TransportGrid {
  std::vector<double> x_edges, y_edges, z_nodes;
};

/// Snapshot of the fields of Study 2 at one instant, on the nodes of the transport grid, [z][y][x]
/// with x fastest.
struct IonSnapshot {
  double time = 0;                   ///< [s]
  std::vector<double> concentration; ///< of the mobile ions [mol/m3]
  std::vector<double> potential;     ///< [V]
  std::vector<double> shear;         ///< shear strain gamma [1]
  // Pressure and swelling, for coupling laws that move water; empty otherwise.
  std::vector<double> pore_pressure; ///< water potential P [Pa]
  std::vector<double> swelling;      ///< volume strain by water that has flowed in, (P - p_u)/M [1]
};

/// Charge of one part of the top electrode (a taxel or the rest), and of the bottom electrode below
/// it, one entry per row [C]. For a line of a crossbar `charge` is that on its own face, and
/// `bottom_charge` is empty.
struct SegmentCharge {
  std::string name;
  std::vector<double> charge, bottom_charge;
  /// Potential of a taxel against the bottom electrode, of a crossing's column against its row, or
  /// of a line against the ground [V]. Empty where no taxel has a circuit of its own.
  std::vector<double> voltage;
  /// Charge that the circuit has passed or holds, without the part that returns through the ground;
  /// for a crossing, the charge that its column has passed while a scan read its row [C]. Empty
  /// where no taxel has a circuit of its own.
  std::vector<double> passed;
  /// Charge that came to the taxel while a scan read other rows [C]; `passed` and this add up to
  /// all charge that came.
  std::vector<double> bypassed;
};

/// Pressure, drive and flow of the water over time, for coupling laws that move it: one entry per
/// row; empty for other laws.
struct WaterRows {
  /// Water potential P at the walls, means over the area [Pa].
  std::vector<double> pressure_top, pressure_bottom;
  /// Parts of the voltage that an open cell would have at once if its core were many Debye lengths
  /// thick [V]: by streaming (water drags the cations) and by dilution of the cations.
  std::vector<double> streaming_voltage, dilution_voltage;
  std::vector<double> largest_pressure; ///< largest |P| in the core [Pa]
  std::vector<double> largest_drive;    ///< largest |g| in the core [V_T/v]
  /// Volume of water that has left through each wall since the first row, and the part of it that
  /// the ionic current has dragged [m3].
  std::vector<double> outflow_top, outflow_bottom, dragged_top, dragged_bottom;
  /// Pressure difference, top minus bottom wall, that the dragged water makes, mean over the area
  /// [Pa]. It does not act back on the ions.
  std::vector<double> dragged_difference;
  /// Pressure on the faces that holds a prescribed compression [Pa]; 0 where none is held.
  std::vector<double> holding_pressure;
};

/// Result of Study 2: charges, voltages and audits with one entry per row (time step), and
/// snapshots of the fields. Row 0 is the initial state, including the instantaneous response to a
/// shear that does not start at 0.
struct IonSolution {
  TransportGrid grid;
  // One entry per time step [rows].
  std::vector<double> time; ///< instants of the rows [s]
  /// Charge on the metal of the top and of the bottom electrode [C]: residual of Poisson's equation
  /// at the wall, summed over the columns.
  std::vector<double> charge_top, charge_bottom;
  /// Charge of the top electrode by the volume integral of Ramo and Shockley, docs/model.md (27),
  /// an audit of `charge_top` [C].
  std::vector<double> ramo_charge_top;
  /// Part of (Q_top - Q_bottom)/2 that changes smoothly at kinks of the shear [C], and its rate
  /// [A]. At given potentials it is the contribution of the ions, behind a circuit the charge that
  /// the circuit conserves; 0 where taxels have circuits of their own. The rest is linear in time
  /// between the rows, as the shear is.
  std::vector<double> relaxation_charge, relaxation_current;
  /// Potential of the top electrode, or of its lead, against the bottom one [V].
  std::vector<double> voltage;
  /// Largest difference in potential along the metal, of the electrode where it is larger [V];
  /// empty without sheet resistance.
  std::vector<double> metal_drop;
  std::vector<double> ion_amount;        ///< amount of mobile ions, the integral of c [mol]
  std::vector<double> min_concentration; ///< smallest concentration of mobile ions [mol/m3]
  std::vector<double> max_potential;     ///< largest |phi| [V]
  std::vector<double> shear_integral;    ///< integral of gamma over the core [m3]
  WaterRows water;
  std::optional<double> taxel_crosstalk; ///< result of `taxel_crosstalk`
  /// Taxels, then the rest of the top electrode; empty without taxels.
  std::vector<SegmentCharge> top_segments;
  /// Lines of a crossbar in the order of `Readout::lines`; empty without.
  std::vector<SegmentCharge> lines;
  /// Charge of the top wall in every lateral column at the last row [C], [y][x].
  std::vector<double> column_charge_top;
  std::vector<IonSnapshot> snapshots;
  // Counters of the solver's work.
  std::size_t steps = 0, rejected_steps = 0, residual_evaluations = 0, krylov_iterations = 0,
              preconditioner_setups = 0;
};

} // namespace ionskin::electrochemistry
