// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/path/steady_sliding.hpp"

#include "ionskin/base/error.hpp"

#include <Eigen/LU>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <vector>

namespace ionskin::mechanics {
namespace {

constexpr int most_active_sets = 50;
/// Of the largest normal force: up to here a straight line stands for the friction law.
constexpr double law_tolerance = 1e-12;

/// The friction limit of a cell as a straight line in its normal force.
struct LimitLine {
  double slope = 0, offset = 0; ///< [1], [N]
  double at(double normal_force) const { return offset + slope * normal_force; }
};

LimitLine tangent(const ContactProblem& problem, int cell, double normal_force) {
  const double slope = problem.friction_limit_slope(cell, normal_force, 0, 0);
  const double limit = problem.friction_limit(cell, normal_force, 0, 0);
  if (!std::isfinite(slope) || !std::isfinite(limit)) {
    throw SolverError(
        fmt::format(
            "the friction law \"{}\" gives no finite number in steady sliding: its limit is "
            "{} Pa with the slope {} at a normal traction of {:.3g} Pa, where slip increment "
            "and time step are 0",
            problem.friction.law, limit / problem.area[cell], slope,
            normal_force / problem.area[cell]),
        "choose another contact.law, or let the law return what it tends to for a time step of 0");
  }
  return {slope, limit - slope * normal_force};
}

/// Tangents at the mean pressure that a load roughly makes; exact for laws in proportion to it.
std::vector<LimitLine> first_tangents(const ContactProblem& problem, const SliderLoad& load) {
  const double area = std::accumulate(problem.area.begin(), problem.area.end(), 0.0);
  std::vector<LimitLine> lines;
  for (int cell = 0; cell < problem.cells(); ++cell) {
    const double force = load.kind == LoadKind::force
                             ? load.value * problem.area[cell] / area
                             : load.value / problem.own_compliance(cell, 0);
    lines.push_back(tangent(problem, cell, std::max(force, std::numeric_limits<double>::min())));
  }
  return lines;
}

/// Normal displacement of a cell per unit friction limit of another.
/// @param drag traction of a limit of 1
double drag_compliance(const ContactProblem& problem, const std::array<double, 2>& drag, int cell,
                       int loaded) {
  const auto& c = problem.compliance;
  return drag[0] * c(3 * cell, 3 * loaded + 1) + drag[1] * c(3 * cell, 3 * loaded + 2);
}

/// Normal forces of the touching cells and, under a given force, the indentation behind them.
Eigen::VectorXd normal_forces(const ContactProblem& problem, const std::array<double, 2>& drag_unit,
                              const std::vector<LimitLine>& limits,
                              const std::vector<int>& touching, const SliderLoad& load) {
  const auto count = static_cast<Eigen::Index>(touching.size());
  const bool force_given = load.kind == LoadKind::force;
  const Eigen::Index size = count + (force_given ? 1 : 0);
  Eigen::MatrixXd matrix(size, size);
  Eigen::VectorXd right(size);
  for (Eigen::Index j = 0; j < count; ++j) {
    right[j] = (force_given ? 0.0 : load.value) - problem.gap[touching[j]];
  }
  for (Eigen::Index j = 0; j < count; ++j) {
    const LimitLine& limit = limits[touching[j]];
    for (Eigen::Index i = 0; i < count; ++i) {
      const double drag = drag_compliance(problem, drag_unit, touching[i], touching[j]);
      matrix(i, j) = problem.compliance(3 * touching[i], 3 * touching[j]) + limit.slope * drag;
      right[i] -= limit.offset * drag;
    }
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

/// The slider at the height of its first touch, without force.
SurfaceState free_of_contact(const ContactProblem& problem, const SliderLoad& load,
                             const std::array<double, 2>& direction, double travel) {
  SurfaceState state;
  state.indentation = *std::ranges::min_element(problem.gap);
  state.force.assign(3 * problem.area.size(), 0.0);
  state.surface = state.force;
  state.slip.assign(problem.area.size(), travel);
  state.step = {load, {travel * direction[0], travel * direction[1]}, 0, state.surface};
  return state;
}

} // namespace

SurfaceState steady_sliding(const ContactProblem& problem, const SliderLoad& load,
                            const std::array<double, 2>& direction, double travel) {
  if (load.kind == LoadKind::force && load.value <= 0) {
    return free_of_contact(problem, load, direction, travel);
  }
  std::vector<LimitLine> limits = first_tangents(problem, load);
  const auto drag_unit = laws::sliding_traction(problem.friction, 1, direction);
  std::vector<bool> touches(problem.area.size(), true);
  for (int iteration = 1; iteration <= most_active_sets; ++iteration) {
    std::vector<int> touching;
    for (int cell = 0; cell < problem.cells(); ++cell) {
      if (touches[cell]) {
        touching.push_back(cell);
      }
    }
    SurfaceState state;
    state.indentation = load.value;
    state.iterations = iteration;
    state.force.assign(3 * problem.area.size(), 0.0);
    Eigen::VectorXd normal;
    double largest = 0;
    if (!touching.empty()) {
      normal = normal_forces(problem, drag_unit, limits, touching, load);
      state.indentation = load.kind == LoadKind::force ? normal[normal.size() - 1] : load.value;
      largest = normal.head(static_cast<Eigen::Index>(touching.size())).cwiseAbs().maxCoeff();
    }
    if (!normal.allFinite()) {
      throw SolverError("the forces of steady sliding are not finite",
                        "bring the moduli of the layers closer to each other");
    }
    bool changed = false;
    for (std::size_t i = 0; i < touching.size(); ++i) {
      const std::size_t at = 3 * static_cast<std::size_t>(touching[i]);
      const double force = normal[static_cast<Eigen::Index>(i)];
      const double limit = limits[touching[i]].at(force);
      state.force[at] = force;
      state.force[at + 1] = limit * drag_unit[0];
      state.force[at + 2] = limit * drag_unit[1];
      const bool bent = force > 0 && std::abs(problem.friction_limit(touching[i], force, 0, 0) -
                                              limit) > law_tolerance * largest;
      if (bent) {
        limits[touching[i]] = tangent(problem, touching[i], force);
      }
      changed = changed || bent || force < 0;
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
    if (load.kind == LoadKind::force && std::ranges::none_of(touches, std::identity{})) {
      // A force needs a cell to bear it: the one that the slider meets first.
      touches[static_cast<std::size_t>(std::ranges::min_element(problem.gap) -
                                       problem.gap.begin())] = true;
      changed = true;
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
