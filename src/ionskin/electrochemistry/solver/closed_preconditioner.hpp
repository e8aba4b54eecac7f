// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/electrochemistry/circuit/terminal_voltage.hpp"
#include "ionskin/electrochemistry/equations/transport_equations.hpp"
#include "ionskin/electrochemistry/solver/preconditioner.hpp"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace ionskin::electrochemistry {

/// Approximate inverse of the Jacobian of a stage, with the circuit between the electrodes. The
/// voltage is a linear function of the concentrations, which adds a matrix of rank one to the
/// Jacobian of `FastDiagonalisation`: its inverse follows from the response to a unit voltage, the
/// same in every column (Sherman and Morrison 1950, doi 10.1214/aoms/1177729893). Conductors of a
/// cut face are part of `FastDiagonalisation` itself.
class ClosedPreconditioner {
public:
  /// @param excess steric excess; nothing for dilute ions
  /// @param electrodes, sheets as for `FastDiagonalisation`
  ClosedPreconditioner(const ScaledGrid& grid, parallel::WorkerTeam& team,
                       std::optional<StericExcess> excess = std::nullopt,
                       const WallElectrodes* electrodes = nullptr,
                       const SheetElectrodes* sheets = nullptr);

  /// Factorises the Jacobian for the lateral average of a state.
  /// @param step implicit part of the time step [relaxation times]
  void factorise(const IonState& state, double step);

  /// Computes out = (approximate Jacobian)^-1 residual; both [2 nodes].
  void apply(const StageProblem& problem, std::span<const double> residual, std::span<double> out);

  /// Sums of a damped change at given potentials of the electrodes, see
  /// `FastDiagonalisation::damped_sums`.
  std::array<std::vector<double>, 2>
  damped_sums(std::span<const double> concentration,
              const std::array<std::vector<double>, 2>& weights) {
    return open_.damped_sums(concentration, weights);
  }

private:
  void answer_to_unit_voltage();

  const ScaledGrid& grid_;
  FastDiagonalisation open_;
  TerminalVoltage voltage_;
  bool answer_is_known_ = false;
  std::vector<double> source_, answer_; ///< [2 nodes]; used with circuits only
};

} // namespace ionskin::electrochemistry
