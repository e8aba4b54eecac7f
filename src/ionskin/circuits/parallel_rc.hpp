// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/circuits/load.hpp"

#include <array>

namespace ionskin::circuits {

/// Resistor and capacitor in parallel between the electrodes as readout circuit, such as the input
/// of an oscilloscope and its cable:
///   I = -U/R - C dU/dt.
/// The voltage decays with the time constant R times the sum of C and the capacitance of the cell.
/// Without C the circuit is a load, with a large C it approaches a short circuit. Source:
/// Kirchhoff's current law.
struct ParallelRc {
  double resistance = 0;  ///< R [ohm]
  double capacitance = 0; ///< C [F]

  static constexpr std::string_view meaning = "a resistor and a capacitor in parallel";
  static constexpr auto parameters() {
    return std::array{
        laws::OwnParameter<ParallelRc>{load_resistance, &ParallelRc::resistance},
        laws::OwnParameter<ParallelRc>{{.name = "load_capacitance",
                                        .dimension = units::Dimension::capacitance,
                                        .lowest = 0,
                                        .highest = 1e6,
                                        .help = "Capacitor beside the resistor.",
                                        .default_value = "\"100 pF\"",
                                        .source = "input and cable of ordinary oscilloscopes"},
                                       &ParallelRc::capacitance}};
  }
  std::string words() const;
  Admittance admittance() const { return {resistance, capacitance}; }
};

} // namespace ionskin::circuits
