// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/electrochemistry/grid/scaled_grid.hpp"

#include <span>
#include <vector>

namespace ionskin::electrochemistry {

/// Equation that the circuit between the electrodes adds to one implicit stage: half the difference
/// of their charges, per area, obeys q = start - conductance * voltage. All scaled.
struct CircuitStage {
  double start = 0; ///< charge that the stage starts from, that on the circuit's capacitor included
  /// Conductance of the circuit, times the implicit part of the step, plus its capacitance; 0 is
  /// open.
  double conductance = 0;
};

/// The potential difference of the electrodes, top minus bottom, as the circuit between them and
/// the charge in the core determine it. By the theorem of Ramo (see `ramo_charge_top`)
///   q = p + voltage/h,   p = mean over the columns of integral((zeta/h - 1/2)(cf - c)),
/// docs/model.md (32): voltage = (start - p)/(1/h + conductance) is an explicit linear function of
/// the concentrations, and needs no unknown of its own.
class TerminalVoltage {
public:
  explicit TerminalVoltage(const ScaledGrid& grid);

  /// Half the difference of the electrodes' charges per area at equal potentials, p.
  double polarisation(std::span<const double> concentration,
                      std::span<const double> fixed_charge) const;
  /// The part of p, or of a change of p, that departures of the ion concentration from `origin`
  /// make.
  double of_ions(std::span<const double> concentration, double origin) const;
  double voltage(const CircuitStage& stage, std::span<const double> concentration,
                 std::span<const double> fixed_charge) const;
  /// Change of the voltage with a change of the concentrations.
  double change(const CircuitStage& stage, std::span<const double> concentration_change) const;

private:
  /// Mean over the columns of the sum over the levels of weight times departure from a value.
  double weighted_mean(const std::vector<double>& weights, std::span<const double> field,
                       double origin) const;

  const ScaledGrid& grid_;
  std::vector<double> ion_weight_, fixed_weight_; ///< per level
};

} // namespace ionskin::electrochemistry
