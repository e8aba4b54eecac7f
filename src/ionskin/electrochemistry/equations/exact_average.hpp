// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/electrochemistry/equations/transport_equations.hpp"
#include "ionskin/electrochemistry/grid/scaled_grid.hpp"

#include <vector>

namespace ionskin::electrochemistry {

/// Corrects a converged stage so that conservation of ions and Gauss's law hold to rounding: it
/// removes the error that Newton's tolerance leaves in the lateral average. The amount of ions is
/// scaled to its known value, and the averaged potential is replaced by the solution of the
/// averaged Poisson equation, a tridiagonal system. With a steric excess, ions are added in
/// proportion to c times the free share of the sites, so that both stay positive.
class ExactAverage {
public:
  /// @param grid must outlive this
  /// @param excess steric excess; nothing for dilute ions
  /// @param electrodes conductors of cut faces; must outlive this; nullptr where no face is cut
  /// @param sheets electrodes with sheet resistances; must outlive this; nullptr for none
  explicit ExactAverage(const ScaledGrid& grid, std::optional<StericExcess> excess = std::nullopt,
                        const WallElectrodes* electrodes = nullptr,
                        const SheetElectrodes* sheets = nullptr);

  /// Corrects `state`, which solves `problem` up to Newton's tolerance.
  void correct(const StageProblem& problem, IonState& state);

  /// Integrates a field [nodes] over the core: sum over the control volumes of height times value.
  static double total(const ScaledGrid& grid, std::span<const double> field);

private:
  /// Shifts the potentials of all conductors of a cut top face by one amount, so that the sum of
  /// their circuits' equations holds. Does nothing where the ground holds one of them, as it always
  /// does with a cut bottom face.
  void restore_charge(const StageProblem& problem, IonState& state) const;
  /// Shifts the potentials of the top metal and its lead by one amount, so that the charge of the
  /// circuit is conserved.
  void restore_lead_charge(const StageProblem& problem, IonState& state) const;
  void restore_amount(double ion_amount, std::span<double> concentration) const;

  const ScaledGrid& grid_;
  std::optional<StericExcess> excess_;
  const WallElectrodes* electrodes_;
  const SheetElectrodes* sheets_;
  TerminalVoltage voltage_;
  /// Scratch values, one per z level.
  std::vector<double> mean_, charge_, diagonal_, potential_;
};

} // namespace ionskin::electrochemistry
