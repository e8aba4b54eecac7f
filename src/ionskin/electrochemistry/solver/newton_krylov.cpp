// SPDX-License-Identifier: Apache-2.0
#include "ionskin/electrochemistry/solver/newton_krylov.hpp"

#include "ionskin/base/largest.hpp"
#include "ionskin/electrochemistry/grid/charges.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ionskin::electrochemistry {
namespace {

/// Rounding errors of the scaled unknowns, which are of order 1.
constexpr double residual_rounding = 1e-14;
constexpr double concentration_rounding = 1e-16;
constexpr int newton_limit = 40;
constexpr int krylov_limit = 80;
constexpr double smallest_step_length = 1.0 / 256.0;
/// Smallest share of a concentration, or of the free share of the sites beside it, that one step
/// leaves.
constexpr double depletion_limit = 0.1;
/// Contraction of simplified Newton's method beyond which Newton's method replaces it.
constexpr double slowest_contraction = 0.2;
/// Number of Krylov iterations in one correction beyond which the preconditioner is renewed.
constexpr int patience = 12;

constexpr std::size_t nodes_per_block = 1024;

} // namespace

NewtonKrylov::NewtonKrylov(const ScaledGrid& grid, double tolerance, parallel::WorkerTeam& team,
                           std::optional<StericExcess> excess, const WallElectrodes* electrodes,
                           const SheetElectrodes* sheets)
    : grid_(grid), tolerance_(tolerance), excess_(excess), team_(team), vectors_(team),
      equations_(grid, team, excess, electrodes, sheets),
      preconditioner_(grid, team, excess, electrodes, sheets), gmres_(2 * grid.nodes(), team),
      exact_average_(grid, excess, electrodes, sheets), trial_(grid.nodes()),
      residual_(2 * grid.nodes()), defect_(residual_.size()), correction_(residual_.size()) {}

void NewtonKrylov::prepare(const IonState& state, double step) {
  preconditioner_.factorise(state, step);
  ++counters_.preconditioner_setups;
}

void NewtonKrylov::rate(const StageProblem& problem, const IonState& state, std::span<double> out) {
  StageProblem unit_step = problem;
  unit_step.start = state.concentration();
  unit_step.step = 1.0;
  equations_.residual(unit_step, state, residual_);
  for (std::size_t i = 0; i < out.size(); ++i) {
    out[i] = -residual_[i] / grid_.height[i / grid_.columns()];
  }
}

double NewtonKrylov::precondition_residual(const StageProblem& problem, const IonState& state) {
  equations_.residual(problem, state, residual_);
  preconditioner_.apply(problem, residual_, defect_);
  ++counters_.residual_evaluations;
  return vectors_.norm(defect_);
}

double NewtonKrylov::allowed_error(const StageProblem& problem, const IonState& state) {
  double scale = base::nan_max(
      base::nan_max(std::abs(problem.potential_bottom), std::abs(problem.potential_top)),
      vectors_.largest_magnitude(state.potential()));
  const double* fixed_charge = problem.fixed_charge.data();
#pragma omp simd reduction(max : scale)
  for (std::size_t i = 0; i < problem.fixed_charge.size(); ++i) {
    scale = std::max(scale, std::abs(fixed_charge[i] - 1.0));
  }
  // The potential of a floating conductor turns rounding errors of charge into a voltage across the
  // whole core.
  const double rounding =
      residual_rounding + (problem.electrodes != nullptr || problem.sheets != nullptr
                               ? concentration_rounding * grid_.thickness * grid_.thickness
                               : 0.0);
  return std::isnan(scale) ? scale : tolerance_ * std::min(scale, 1.0) + rounding;
}

std::array<std::vector<double>, 2>
NewtonKrylov::damped_charges(std::span<const double> change,
                             const std::array<std::vector<double>, 2>& charges) {
  const std::size_t columns = grid_.columns(), nodes = grid_.nodes();
  for (std::size_t i = 0; i < nodes; ++i) {
    residual_[i] = grid_.height[i / columns] * change[i];
    residual_[nodes + i] = 0.0;
  }
  std::ranges::copy(charges[bottom_wall], residual_.begin() + static_cast<std::ptrdiff_t>(nodes));
  std::ranges::copy(charges[top_wall], residual_.end() - static_cast<std::ptrdiff_t>(columns));
  preconditioner_.apply(StageProblem{}, residual_, trial_.values);
  for (double& concentration : trial_.concentration()) {
    concentration += 1.0;
  }
  WallCharges left;
  wall_charges(grid_, trial_, std::vector<double>(nodes, 1.0), left);
  return {std::move(left.bottom), std::move(left.top)};
}

bool NewtonKrylov::solve(const StageProblem& problem, IonState& state) {
  const double allowed = allowed_error(problem, state);
  if (!std::isfinite(allowed) || !std::isfinite(precondition_residual(problem, state))) {
    return false;
  }
  if (correct_by_defects(problem, state, allowed)) {
    return true;
  }
  bool renew = false;
  for (int iteration = 0; iteration < newton_limit; ++iteration) {
    if (renew) {
      prepare(state, problem.step);
      precondition_residual(problem, state);
    }
    const double error = vectors_.largest_magnitude(defect_);
    if (!std::isfinite(vectors_.norm(defect_))) {
      return false;
    }
    if (error <= allowed) {
      finish(problem, state);
      return true;
    }
    const int iterations =
        solve_linearised(problem, state, std::clamp(0.3 * allowed / error, 1e-5, 1e-2));
    const bool reduced = search(problem, state);
    if (!reduced && renew) {
      return false;
    }
    // The preconditioner also measures the errors: an outdated one may mislead the line search.
    renew = !reduced || iterations > patience;
  }
  return false;
}

bool NewtonKrylov::correct_by_defects(const StageProblem& problem, IonState& state,
                                      double allowed) {
  double error = vectors_.largest_magnitude(defect_);
  double contraction = 1.0; // not known yet
  while (contraction * error > allowed) {
    step(state, 1.0, defect_, trial_);
    std::swap(defect_, correction_);
    const bool finite = std::isfinite(precondition_residual(problem, trial_));
    const double left = vectors_.largest_magnitude(defect_);
    if (!finite || left > slowest_contraction * error) {
      std::swap(defect_, correction_); // of the state as it was
      return false;
    }
    std::swap(state.values, trial_.values);
    contraction = left / error;
    error = left;
  }
  finish(problem, state);
  return true;
}

/// Applies the last defect as a correction, which is nearly exact and already computed, and
/// restores the averages.
void NewtonKrylov::finish(const StageProblem& problem, IonState& state) {
  step(state, 1.0, defect_, trial_);
  std::swap(state.values, trial_.values);
  exact_average_.correct(problem, state);
}

int NewtonKrylov::solve_linearised(const StageProblem& problem, const IonState& state,
                                   double reduction) {
  equations_.linearise(problem, state);
  const auto preconditioned_jacobian = [&](std::span<const double> x, std::span<double> y) {
    equations_.apply_jacobian(x, residual_);
    preconditioner_.apply(problem, residual_, y);
  };
  const Gmres::Result result =
      gmres_.solve(preconditioned_jacobian, defect_, correction_, reduction, krylov_limit);
  counters_.krylov_iterations += static_cast<std::size_t>(result.iterations);
  return result.iterations;
}

/// Computes out = state - length correction, except that no concentration, and no free share of the
/// sites, falls below a tenth of itself.
void NewtonKrylov::step(const IonState& state, double length, std::span<const double> correction,
                        IonState& out) {
  const std::size_t nodes = state.nodes();
  const double* from = state.values.data();
  const double* change = correction.data();
  double* to = out.values.data();
  team_.for_blocks(nodes, nodes_per_block, [&](std::size_t begin, std::size_t end, std::size_t) {
#pragma omp simd
    for (std::size_t i = begin; i < end; ++i) {
      to[i] = std::max(from[i] - length * change[i], depletion_limit * from[i]);
    }
#pragma omp simd
    for (std::size_t i = nodes + begin; i < nodes + end; ++i) {
      to[i] = from[i] - length * change[i];
    }
  });
  if (excess_) {
    excess_->keep_room(state.concentration(), out.concentration(), depletion_limit);
  }
}

bool NewtonKrylov::search(const StageProblem& problem, IonState& state) {
  const double start = vectors_.norm(defect_);
  for (double length = 1.0; length >= smallest_step_length; length *= 0.5) {
    step(state, length, correction_, trial_);
    if (precondition_residual(problem, trial_) <= (1.0 - 0.25 * length) * start) {
      std::swap(state.values, trial_.values);
      return true;
    }
  }
  return false;
}

} // namespace ionskin::electrochemistry
