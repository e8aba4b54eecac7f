// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/steady_sliding.hpp"

#include "ionskin/base/error.hpp"

#include <Eigen/LU>

#include <vector>

namespace ionskin::mechanics {
namespace {

constexpr int most_active_sets = 50;

/// Normal displacement of a cell per unit normal force of another that also drags along the slide.
double dragging_compliance(const ContactProblem& problem, const std::array<double, 2>& drag,
                           int cell, int loaded) {
  const auto& c = problem.compliance;
  return c(3 * cell, 3 * loaded) + drag[0] * c(3 * cell, 3 * loaded + 1) +
         drag[1] * c(3 * cell, 3 * loaded + 2);
}

/// Normal forces of the touching cells and, under a given force, the indentation behind them.
Eigen::VectorXd normal_forces(const ContactProblem& problem, const std::array<double, 2>& drag,
                              const std::vector<int>& touching, const SliderLoad& load) {
  const auto count = static_cast<Eigen::Index>(touching.size());
  const bool force_given = load.kind == LoadKind::force;
  const Eigen::Index size = count + (force_given ? 1 : 0);
  Eigen::MatrixXd matrix(size, size);
  Eigen::VectorXd right(size);
  for (Eigen::Index j = 0; j < count; ++j) {
    for (Eigen::Index i = 0; i < count; ++i) {
      matrix(i, j) = dragging_compliance(problem, drag, touching[i], touching[j]);
    }
    right[j] = (force_given ? 0.0 : load.value) - problem.gap[touching[j]];
  }
  if (force_given) {
    // Scaled so that pivots compare displacements with displacements.
    const double scale = problem.own_compliance(touching.front(), 0);
    matrix.col(count).setConstant(-1);
    matrix.row(count).setConstant(scale);
    matrix(count, count) = 0;
    right[count] = scale * load.value;
  }
  return matrix.partialPivLu().solve(right);
}

} // namespace

SurfaceState steady_sliding(const ContactProblem& problem, const SliderLoad& load,
                            const std::array<double, 2>& direction, double travel) {
  const double mu = problem.friction.coefficient;
  const std::array<double, 2> drag{mu * direction[0], mu * direction[1]};
  std::vector<bool> touches(problem.area.size(), true);
  for (int iteration = 1; iteration <= most_active_sets; ++iteration) {
    std::vector<int> touching;
    for (int cell = 0; cell < problem.cells(); ++cell) {
      if (touches[cell]) {
        touching.push_back(cell);
      }
    }
    const Eigen::VectorXd normal = normal_forces(problem, drag, touching, load);
    SurfaceState state;
    state.indentation = load.kind == LoadKind::force ? normal[normal.size() - 1] : load.value;
    state.iterations = iteration;
    state.force.assign(3 * problem.area.size(), 0.0);
    bool changed = false;
    for (std::size_t i = 0; i < touching.size(); ++i) {
      const std::size_t at = 3 * static_cast<std::size_t>(touching[i]);
      const double force = normal[static_cast<Eigen::Index>(i)];
      state.force[at] = force;
      state.force[at + 1] = drag[0] * force;
      state.force[at + 2] = drag[1] * force;
      changed = changed || force < 0;
      touches[touching[i]] = force >= 0;
    }
    state.surface = problem.surface_displacement(state.force);
    for (int cell = 0; cell < problem.cells(); ++cell) {
      const std::size_t at = 3 * static_cast<std::size_t>(cell);
      const bool penetrates =
          state.force[at] == 0 &&
          state.surface[at] < state.indentation * (1 - 1e-12) - problem.gap[cell];
      changed = changed || penetrates;
      touches[cell] = touches[cell] || penetrates;
    }
    if (!changed) {
      state.slip.assign(problem.area.size(), travel);
      state.step = {load, {travel * direction[0], travel * direction[1]}, 0, state.surface};
      return state;
    }
  }
  throw SolverError("the active set of steady sliding cycles", "lower contact.friction");
}

} // namespace ionskin::mechanics
