// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"

namespace ionskin::electrochemistry {

/// The cell at rest as the few parts that an instrument meets, each for the whole skin, and the
/// times that they make.
struct CellCircuit {
  double layers = 0;        ///< capacitance of both double layers in series [F]
  double geometric = 0;     ///< capacitance of the core as a dielectric, eps A/h [F]
  double core = 0;          ///< resistance of the core, h/(sigma A) [ohm]
  double screening = 0;     ///< core and geometric capacitance [s]
  double charging = 0;      ///< core and double layers [s]
  double metal_squares = 0; ///< resistance of a square of both metals [ohm]; 0 for none

  /// Time in which charge comes along the metal to the double layers farthest from the leads,
  /// docs/model.md (70) [s].
  /// @param squares resistance of a square of both metals [ohm]
  double metal_time(double squares) const { return metal_time_per_ohm * squares; }
  double metal_time_per_ohm = 0;
};

CellCircuit cell_circuit(const Case& input);

} // namespace ionskin::electrochemistry
