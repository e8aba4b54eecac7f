// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/electrochemistry/equations/transport_equations.hpp"
#include "ionskin/electrochemistry/grid/scaled_grid.hpp"

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
  /// @param electrodes of the faces where they are cut; must outlive this, nullptr otherwise
  /// @param sheets electrodes with sheet resistances; must outlive this, nullptr for none
  explicit ExactAverage(const ScaledGrid& grid, std::optional<StericExcess> excess = std::nullopt,
                        const WallElectrodes* electrodes = nullptr,
                        const SheetElectrodes* sheets = nullptr);

  void correct(const StageProblem& problem, IonState& state);

  /// Sum over the control volumes of height times a field.
  static double total(const ScaledGrid& grid, std::span<const double> field);

private:
  /// Shifts all conductors of a cut top face alike, so that the sum of what their circuits ask
  /// holds; not where one of them is held, as it is of a cut bottom face.
  void restore_charge(const StageProblem& problem, IonState& state) const;
  /// Shifts the top metal with its lead, so that the charge that passes the circuit holds.
  void restore_lead_charge(const StageProblem& problem, IonState& state) const;
  void restore_amount(double ion_amount, std::span<double> concentration) const;

  const ScaledGrid& grid_;
  std::optional<StericExcess> excess_;
  const WallElectrodes* electrodes_;
  const SheetElectrodes* sheets_;
  TerminalVoltage voltage_;
  std::vector<double> mean_, charge_, diagonal_, potential_; ///< per level
};

} // namespace ionskin::electrochemistry
