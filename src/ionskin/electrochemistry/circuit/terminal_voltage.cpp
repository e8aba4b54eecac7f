// SPDX-License-Identifier: Apache-2.0
#include "ionskin/electrochemistry/circuit/terminal_voltage.hpp"

#include "ionskin/electrochemistry/grid/charges.hpp"

namespace ionskin::electrochemistry {

TerminalVoltage::TerminalVoltage(const ScaledGrid& grid) : grid_(grid) {
  for (std::size_t k = 0; k < grid.levels; ++k) {
    ion_weight_.push_back(ramo_weight(grid, k) - 0.5 * grid.height[k]);
    fixed_weight_.push_back((grid.position[k] - 0.5) * grid.height[k]);
  }
}

double TerminalVoltage::weighted_mean(const std::vector<double>& weights,
                                      std::span<const double> field, double origin) const {
  const std::size_t columns = grid_.columns();
  double total = 0.0;
  for (std::size_t k = 0; k < grid_.levels; ++k) {
    const double* level = field.data() + k * columns;
    double sum = 0.0;
#pragma omp simd reduction(+ : sum)
    for (std::size_t i = 0; i < columns; ++i) {
      sum += level[i] - origin;
    }
    total += weights[k] * sum;
  }
  return total / static_cast<double>(columns);
}

double TerminalVoltage::polarisation(std::span<const double> concentration,
                                     std::span<const double> fixed_charge) const {
  return weighted_mean(fixed_weight_, fixed_charge, 1.0) + of_ions(concentration, 1.0);
}

double TerminalVoltage::of_ions(std::span<const double> concentration, double origin) const {
  return -weighted_mean(ion_weight_, concentration, origin);
}

double TerminalVoltage::voltage(const CircuitStage& stage, std::span<const double> concentration,
                                std::span<const double> fixed_charge) const {
  return (stage.start - polarisation(concentration, fixed_charge)) /
         (1.0 / grid_.thickness + stage.conductance);
}

double TerminalVoltage::change(const CircuitStage& stage,
                               std::span<const double> concentration_change) const {
  return -of_ions(concentration_change, 0.0) / (1.0 / grid_.thickness + stage.conductance);
}

} // namespace ionskin::electrochemistry
