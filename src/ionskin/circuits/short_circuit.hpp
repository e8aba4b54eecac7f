// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/circuits/circuit.hpp"

namespace ionskin::circuits {

/// Short circuit as readout circuit: both electrodes at one potential. Source: the skin model that
/// ionskin reproduces.
struct ShortCircuit {
  static constexpr std::string_view meaning = "a short circuit";
  static constexpr auto parameters() { return laws::no_parameters<ShortCircuit>; }
  std::string words() const { return "short circuit"; }
};

} // namespace ionskin::circuits
