// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/circuits/circuit.hpp"

#include <array>
#include <optional>

namespace ionskin::electrochemistry {

/// Solves dx/dt = rate (source - x) exactly over a time step, for a source that is linear in time,
/// and returns x at its end.
/// @param amount x at the begin
/// @param rate [1/s]
/// @param duration of the step [s]
/// @param source_begin, source_end source at both ends of the step, in the unit of x
double relaxed(double amount, double rate, double duration, double source_begin, double source_end);

/// Mean charge of a cell with thin double layers: both layers in series, the core between them and
/// the readout circuit, docs/model.md (35). With q the charge of the top electrode, U the voltage,
/// S = Omega_top - Omega_bottom the electromotive force, C and R the capacitance and the resistance
/// of the cell,
///   R dq/dt = U + S - q/C,   dq/dt + C_ext dU/dt = -U/R_ext,
/// or U = 0 in the short circuit. The solution is exact for S linear in time.
class LayerCircuit {
public:
  /// @param capacitance C of both double layers in series [F]
  /// @param resistance R of the core [ohm]
  /// @param admittance readout circuit; nothing for a short circuit
  LayerCircuit(double capacitance, double resistance,
               const std::optional<circuits::Admittance>& admittance);

  /// State of cell and circuit at an instant.
  struct State {
    double charge = 0, voltage = 0; ///< q [C], U [V]
    double rate = 0;                ///< dq/dt [A]
  };
  /// State at the first instant, right after S is switched on: no charge has flowed, U follows from
  /// the circuit.
  /// @param force S [V]
  State start(double force) const;
  /// State at the end of a time step that starts from `begin`.
  /// @param duration of the step [s]
  /// @param force_begin, force_end S at both ends of the step, linear in between [V]
  State step(const State& begin, double duration, double force_begin, double force_end) const;

private:
  using Pair = std::array<double, 2>;
  State complete(double charge, double voltage, double force) const;

  double capacitance_, resistance_;
  double conductance_ = 0, parallel_ = 0; ///< 1/R_ext [S] and C_ext [F]
  bool shorted_;
  // Modes of charge and voltage behind a circuit with a capacitor: their rates [1/s], and how S
  // drives them.
  Pair rate_{}, drive_{};
  std::array<double, 4> to_modes_{}, from_modes_{};
};

} // namespace ionskin::electrochemistry
