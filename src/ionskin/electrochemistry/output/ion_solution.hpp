// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
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
};

/// Charge on the metal of one part of the top electrode, one entry per row [C].
struct SegmentCharge {
  std::string name;
  std::vector<double> charge;
};

/// All of Study 2. Row 0 is the initial state with the response to a shear that does not start at
/// 0.
struct IonSolution {
  TransportGrid grid;
  // One entry per time step [rows].
  std::vector<double> time; ///< [s]
  /// Charge on the metal [C]: residual of Poisson's equation at each wall, summed over the columns.
  std::vector<double> charge_top, charge_bottom;
  /// The same by the volume formula of design E2 (Ramo) [C].
  std::vector<double> ramo_charge_top;
  /// The part of half the difference of the charges that changes smoothly at kinks of the shear,
  /// and its rate [C], [A]: the ions' part at given potentials, all of it behind a circuit. The
  /// rest follows the shear linearly between the rows.
  std::vector<double> relaxation_charge, relaxation_current;
  std::vector<double> voltage;             ///< of the top electrode against the bottom one [V]
  std::vector<double> ion_amount;          ///< integral of c [mol]
  std::vector<double> min_concentration;   ///< [mol/m3]
  std::vector<double> max_potential;       ///< largest |phi| [V]
  std::vector<double> shear_integral;      ///< of gamma on the transport grid [m3]
  std::vector<SegmentCharge> top_segments; ///< the taxels and the rest; empty without taxels
  /// Charge of the top wall per column at the last row [C], [y][x].
  std::vector<double> column_charge_top;
  std::vector<IonSnapshot> snapshots;
  // counters
  std::size_t steps = 0, rejected_steps = 0, residual_evaluations = 0, krylov_iterations = 0,
              preconditioner_setups = 0;
};

} // namespace ionskin::electrochemistry
