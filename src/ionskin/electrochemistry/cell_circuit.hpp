// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"

namespace ionskin::electrochemistry {

/// Equivalent circuit of the cell at rest: resistance and capacitances that an instrument sees,
/// each for the area of the whole skin, and their time constants.
struct CellCircuit {
  double layers = 0;    ///< capacitance of both double layers in series [F]
  double geometric = 0; ///< capacitance of the core as a dielectric, eps A/h [F]
  double core = 0;      ///< resistance of the core to ionic current, h/(sigma A) [ohm]
  double screening = 0; ///< time constant, `core` times `geometric` [s]
  double charging = 0;  ///< time constant, `core` times `layers` [s]
  /// Sum of the electrodes' sheet resistances [ohm per square]; 0 for none.
  double metal_squares = 0;

  /// Time constant with which charge moves along the metal to the double layers farthest from the
  /// leads, docs/model.md (70) [s].
  /// @param squares sum of the sheet resistances of both electrodes [ohm per square]
  double metal_time(double squares) const { return metal_time_per_ohm * squares; }
  double metal_time_per_ohm = 0; ///< `metal_time` for 1 ohm per square [s]
};

/// Computes the equivalent circuit at rest from the constants of a case.
CellCircuit cell_circuit(const Case& input);

} // namespace ionskin::electrochemistry
