// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/electrochemistry/scaled_grid.hpp"
#include "ionskin/electrochemistry/transport_equations.hpp"

#include <vector>

namespace ionskin::electrochemistry {

/// Removes from a converged stage what Newton's tolerance leaves in the laterally averaged mode, so
/// that conservation of ions and Gauss's law hold to rounding: the amount of ions is scaled to its
/// known value, and the averaged potential is replaced by the solution of the averaged Poisson
/// equation, a tridiagonal system.
class ExactAverage {
public:
  explicit ExactAverage(const ScaledGrid& grid);

  void correct(const StageProblem& problem, IonState& state);

  /// Sum over the control volumes of height times a field.
  static double total(const ScaledGrid& grid, std::span<const double> field);

private:
  const ScaledGrid& grid_;
  TerminalVoltage voltage_;
  std::vector<double> mean_, charge_, diagonal_, potential_; ///< per level
};

} // namespace ionskin::electrochemistry
