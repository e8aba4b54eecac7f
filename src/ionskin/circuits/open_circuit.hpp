// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/circuits/circuit.hpp"

namespace ionskin::circuits {

/// Open circuit as readout circuit: the electrodes are not connected, so that the difference
/// current is I = 0. Source: Kirchhoff's current law.
struct OpenCircuit {
  static constexpr std::string_view meaning = "nothing";
  static constexpr auto parameters() { return laws::no_parameters<OpenCircuit>; }
  std::string words() const { return "open circuit"; }
  Admittance admittance() const { return {}; }
};

} // namespace ionskin::circuits
