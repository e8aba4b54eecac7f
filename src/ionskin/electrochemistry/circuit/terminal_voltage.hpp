// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/electrochemistry/grid/scaled_grid.hpp"

#include <span>
#include <vector>

namespace ionskin::electrochemistry {

/// Equation that the circuit between the electrodes adds to one implicit stage: q = start -
/// conductance * voltage, with q half of the difference of the electrodes' charges per area. All
/// scaled.
struct CircuitStage {
  double start = 0; ///< charge per area the stage starts from, with the circuit's capacitor
  /// 1/R of the circuit times the implicit part of the time step, plus its C; 0 is open.
  double conductance = 0;
};

/// Voltage between equipotential electrodes, top minus bottom, as it follows from the circuit
/// between them and the charge in the core. By the theorem of Ramo (see `ramo_charge_top`)
///   q = q_sc + voltage/h,   q_sc = mean over the columns of integral((zeta/h - 1/2)(cf - c)),
/// docs/model.md (32): voltage = (start - q_sc)/(1/h + conductance) is an explicit linear function
/// of the concentrations, and needs no unknown of its own. All scaled.
class TerminalVoltage {
public:
  explicit TerminalVoltage(const ScaledGrid& grid);

  /// Computes q_sc, half of the difference of the electrodes' charges per area at equal potentials
  /// [F c0 lambda].
  /// @param concentration c of the ions [c0/v], [nodes]
  /// @param fixed_charge cf/c0 [nodes]
  double polarisation(std::span<const double> concentration,
                      std::span<const double> fixed_charge) const;
  /// Computes the part of q_sc that the ions make by the departure of their concentration from
  /// `origin`. For a change of the concentration, with `origin` 0, it is the change of q_sc.
  double of_ions(std::span<const double> concentration, double origin) const;
  /// Computes the voltage [R T/(v F)] that satisfies the equation of the circuit; arguments as for
  /// `polarisation`.
  double voltage(const CircuitStage& stage, std::span<const double> concentration,
                 std::span<const double> fixed_charge) const;
  /// Computes the change of the voltage with a change of the concentrations [nodes].
  double change(const CircuitStage& stage, std::span<const double> concentration_change) const;

private:
  /// Mean over the columns of the sum over the levels of weight times departure from a value.
  double weighted_mean(const std::vector<double>& weights, std::span<const double> field,
                       double origin) const;

  const ScaledGrid& grid_;
  std::vector<double> ion_weight_, fixed_weight_; ///< weights of q_sc per z level
};

} // namespace ionskin::electrochemistry
