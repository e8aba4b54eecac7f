// SPDX-License-Identifier: Apache-2.0
#include "ionskin/electrochemistry/equations/exact_average.hpp"

#include "ionskin/electrochemistry/grid/charges.hpp"

namespace ionskin::electrochemistry {
namespace {

/// Sums the departure from `origin` over the columns of a z level.
double level_sum(std::span<const double> field, std::size_t level, std::size_t columns,
                 double origin) {
  const double* values = field.data() + level * columns;
  double sum = 0.0;
#pragma omp simd reduction(+ : sum)
  for (std::size_t i = 0; i < columns; ++i) {
    sum += values[i] - origin;
  }
  return sum;
}

} // namespace

ExactAverage::ExactAverage(const ScaledGrid& grid, std::optional<StericExcess> excess,
                           const WallElectrodes* electrodes, const SheetElectrodes* sheets)
    : grid_(grid), excess_(excess), electrodes_(electrodes), sheets_(sheets), voltage_(grid),
      mean_(grid.levels), charge_(grid.levels), diagonal_(grid.levels), potential_(grid.levels) {}

double ExactAverage::total(const ScaledGrid& grid, std::span<const double> field) {
  double total = 0.0;
  for (std::size_t k = 0; k < grid.levels; ++k) {
    total += grid.height[k] * level_sum(field, k, grid.columns(), 0.0);
  }
  return total;
}

void ExactAverage::restore_amount(double ion_amount, std::span<double> concentration) const {
  const double amount = total(grid_, concentration);
  if (!excess_) {
    const double factor = ion_amount / amount;
    for (double& value : concentration) {
      value *= factor;
    }
    return;
  }
  double weight = 0.0;
  for (std::size_t i = 0; i < concentration.size(); ++i) {
    weight +=
        grid_.height[i / grid_.columns()] * concentration[i] * excess_->room(concentration[i]);
  }
  const double share = (ion_amount - amount) / weight;
  for (double& value : concentration) {
    value += share * value * excess_->room(value);
  }
}

void ExactAverage::restore_charge(const StageProblem& problem, IonState& state) const {
  const ElectrodeStage& stage = *problem.electrodes;
  const auto top = state.potential().last(grid_.columns());
  const std::vector<double> potentials = electrodes_->potentials(state.potential());
  double missing = -ramo_charge_top(grid_, state, problem.fixed_charge);
  double per_potential = static_cast<double>(grid_.columns()) / grid_.thickness;
  for (std::size_t e = 0; e < potentials.size(); ++e) {
    if (stage.holds(e)) {
      return;
    }
    missing += stage.start[e] - stage.conductance[e] * potentials[e];
    per_potential += stage.conductance[e];
  }
  for (double& potential : top) {
    potential += missing / per_potential;
  }
}

void ExactAverage::restore_lead_charge(const StageProblem& problem, IonState& state) const {
  const SheetStage& stage = *problem.sheets;
  if (!stage.circuit) {
    return;
  }
  const std::size_t columns = grid_.columns();
  const auto top = state.potential().last(columns);
  const double lead = sheets_->lead_potential(stage, problem.potential_bottom, 0.0, top);
  double net = -static_cast<double>(columns) * stage.passed; // returns through the ground
  for (const double charge : stage.start[top_wall]) {
    net += charge;
  }
  const double missing =
      net +
      static_cast<double>(columns) *
          (stage.circuit->start - stage.circuit->conductance * (lead - problem.potential_bottom)) -
      ramo_charge_top(grid_, state, problem.fixed_charge);
  const double follows =
      sheets_->lead_change(stage, std::vector<double>(columns, 1.0)) * stage.circuit->conductance;
  const double shift = missing / (static_cast<double>(columns) * (1.0 / grid_.thickness + follows));
  for (double& potential : top) {
    potential += shift;
  }
}

void ExactAverage::correct(const StageProblem& problem, IonState& state) {
  restore_amount(problem.ion_amount, state.concentration());
  if (problem.electrodes != nullptr) {
    restore_charge(problem, state);
  }
  if (problem.sheets != nullptr) {
    restore_lead_charge(problem, state);
  }
  const std::size_t columns = grid_.columns(), top = grid_.levels - 1;
  const auto count = static_cast<double>(columns);
  const bool top_varies = problem.electrodes != nullptr || problem.sheets != nullptr;
  const double potential_top = top_varies ? level_sum(state.potential(), top, columns, 0.0) / count
                                          : top_potential(problem, voltage_, state.concentration());
  for (std::size_t k = 0; k <= top; ++k) {
    mean_[k] = level_sum(state.concentration(), k, columns, 1.0) / count;
  }
  // Elimination from the bottom wall up, then substitution from the top wall down.
  const bool bottom_varies =
      problem.sheets != nullptr || (problem.electrodes != nullptr && electrodes_->on_bottom());
  potential_[0] = bottom_varies ? level_sum(state.potential(), 0, columns, 0.0) / count
                                : problem.potential_bottom;
  diagonal_[0] = 1.0;
  for (std::size_t k = 1; k < top; ++k) {
    const double down = 1.0 / grid_.spacing[k - 1], up = 1.0 / grid_.spacing[k];
    const double previous_upper = k == 1 ? 0.0 : -down;
    const ChargeWeights weight = charge_weights(grid_, k);
    charge_[k] = weight.below * mean_[k - 1] + weight.here * mean_[k] +
                 weight.above * mean_[k + 1] -
                 grid_.height[k] * level_sum(problem.fixed_charge, k, columns, 1.0) / count;
    const double factor_below = -down / diagonal_[k - 1];
    diagonal_[k] = up + down - factor_below * previous_upper;
    potential_[k] = charge_[k] - factor_below * potential_[k - 1];
  }
  potential_[top] = potential_top;
  for (std::size_t k = top; k-- > 1;) {
    potential_[k] = (potential_[k] + potential_[k + 1] / grid_.spacing[k]) / diagonal_[k];
  }
  const auto phi = state.potential();
  for (std::size_t i = 0; i < columns; ++i) {
    if (!bottom_varies) {
      phi[i] = problem.potential_bottom;
    }
    if (!top_varies) {
      phi[top * columns + i] = potential_top;
    }
  }
  for (std::size_t k = 1; k < top; ++k) {
    const double shift = potential_[k] - level_sum(phi, k, columns, 0.0) / count;
    for (double& value : phi.subspan(k * columns, columns)) {
      value += shift;
    }
  }
}

} // namespace ionskin::electrochemistry
