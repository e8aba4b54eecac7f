// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/circuits/circuit.hpp"

#include <array>

namespace ionskin::circuits {

/// Parameter `readout.load_resistance`, shared by all circuits that have a load resistor.
inline constexpr laws::LawParameter load_resistance{
    .name = "load_resistance",
    .dimension = units::Dimension::resistance,
    .lowest = 1e-3,
    .highest = 1e18,
    .help = "Resistor between the electrodes.",
    .default_value = "\"1 MOhm\"",
    .source = "input resistance of ordinary oscilloscopes"};

/// Load resistor between the electrodes as readout circuit: I = -U/R, with the signs of
/// `Admittance`. Source: Ohm's law.
struct Load {
  double resistance = 0; ///< R [ohm]

  static constexpr std::string_view meaning = "a load resistor";
  static constexpr auto parameters() {
    return std::array{laws::OwnParameter<Load>{load_resistance, &Load::resistance}};
  }
  std::string words() const;
  Admittance admittance() const { return {.resistance = resistance}; }
};

} // namespace ionskin::circuits
