// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/electrochemistry/scaled_grid.hpp"
#include "ionskin/electrochemistry/transport_equations.hpp"

#include <vector>

namespace ionskin::electrochemistry {

/// Removes from a converged stage what Newton's tolerance leaves in the laterally averaged mode, so
/// that conservation of ions and Gauss's law hold to rounding: the amount of ions is scaled to its
/// known value, and the averaged potential is replaced by the solution of the averaged Poisson
/// equation, a tridiagonal system. With a steric excess ions are added in proportion to c times the
/// room beside them, so that both stay positive.
class ExactAverage {
public:
  /// @param excess nothing for dilute ions
  ExactAverage(const ScaledGrid& grid, WorkerTeam& team,
               std::optional<StericExcess> excess = std::nullopt);

  void correct(const StageProblem& problem, IonState& state);

  /// Sum over the control volumes of height times a field.
  static double total(const ScaledGrid& grid, std::span<const double> field);

private:
  template <class Body> void for_levels(const Body& body) const;
  void restore_amount(double ion_amount, std::span<double> concentration);

  const ScaledGrid& grid_;
  WorkerTeam& team_;
  std::optional<StericExcess> excess_;
  TerminalVoltage voltage_;
  std::vector<double> amount_, mean_, fixed_mean_;    ///< per level
  std::vector<double> charge_, diagonal_, potential_; ///< per level
};

} // namespace ionskin::electrochemistry
