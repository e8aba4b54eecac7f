// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/circuits/circuit.hpp"

#include <array>
#include <optional>

namespace ionskin::electrochemistry {

/// An amount that relaxes at a rate towards a source that is linear in time over a step:
/// dx/dt = rate (source - x), exact.
double relaxed(double amount, double rate, double duration, double source_begin, double source_end);

/// Two thin double layers in series, the core between them and the circuit outside, all means over
/// the electrodes: with q the charge of the top electrode, U the voltage, S = Omega_top -
/// Omega_bottom, capacitance C and resistance R of the cell,
///   R dq/dt = U + S - q/C,   dq/dt + C_ext dU/dt = -U/R_ext,
/// or U = 0 in the short circuit, docs/model.md (35). Exact for S linear in time.
class LayerCircuit {
public:
  /// @param capacitance [F], resistance [ohm] of the cell
  LayerCircuit(double capacitance, double resistance,
               const std::optional<circuits::Admittance>& admittance);

  struct State {
    double charge = 0, voltage = 0; ///< q [C], U [V]
    double rate = 0;                ///< dq/dt [A]
  };
  /// State at rest before S is switched on: nothing has flowed, U from the circuit.
  /// @param voltage S [V]
  State start(double force) const;
  State step(const State& begin, double duration, double force_begin, double force_end) const;

private:
  using Pair = std::array<double, 2>;
  State complete(double charge, double voltage, double force) const;

  double capacitance_, resistance_;
  double conductance_ = 0, parallel_ = 0; ///< outside
  bool shorted_;
  // Modes of charge and voltage with a capacitor outside, their rates and how S drives
  // them.
  Pair rate_{}, drive_{};
  std::array<double, 4> to_modes_{}, from_modes_{};
};

} // namespace ionskin::electrochemistry
