// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/surface/contact_solver.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/mechanics/surface/adhesive_force.hpp"
#include "ionskin/mechanics/surface/contact_newton.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace ionskin::mechanics {
namespace {

/// Mean, weighted with the normal forces, of the indentation at which the cells lie on the slider's
/// face under given forces [m].
double mean_indentation(const ContactProblem& problem, const CellVector& force) {
  const CellVector surface = problem.surface_displacement(force);
  double sum = 0, total = 0;
  for (std::size_t cell = 0; cell < problem.area.size(); ++cell) {
    sum += force[3 * cell] * (surface[3 * cell] + problem.gap[cell]);
    total += force[3 * cell];
  }
  return total > 0 ? sum / total : 0.0;
}

[[noreturn]] void give_up(const SliderLoad& load, int iterations) {
  const std::string where = load.kind == LoadKind::force
                                ? fmt::format("under a force of {:.3g} N", load.value)
                                : fmt::format("at an indentation of {:.3g} um", load.value * 1e6);
  throw SolverError(
      fmt::format("the contact solver did not converge in {} iterations {}", iterations, where),
      "lower contact.friction, or change numerics.mesh_refinement");
}

/// Solves a series of loads from the first touch on, each twice as heavy as the one before, up to
/// the given load. Most cells that touch under a load already touched under half of it. On a stiff
/// electrode over a soft core, Newton's method diverges when it begins without touching cells.
Iterate solve_by_growing_loads(const ContactProblem& problem, const SliderStep& step) {
  constexpr int doublings = 12;
  const double first_touch = step.load.kind == LoadKind::force ? 0.0 : problem.least_free_gap();
  SliderStep less = step;
  ContactNewton newton;
  Iterate iterate{CellVector(3 * problem.area.size(), 0.0), 0};
  for (int left = doublings; left >= 0; --left) {
    less.load.value = first_touch + std::ldexp(step.load.value - first_touch, -left);
    if (!newton.solve(problem, less, iterate, Patience::much)) {
      give_up(step.load, newton.iterations());
    }
  }
  return iterate;
}

} // namespace

SurfaceState surface_state(const ContactProblem& problem, const SliderStep& step, CellVector force,
                           double indentation, int iterations) {
  SurfaceState state;
  state.surface = problem.surface_displacement(force);
  for (int cell = 0; cell < problem.cells(); ++cell) {
    const auto slip = slip_increment(step, state.surface, cell);
    state.slip.push_back(std::hypot(slip[0], slip[1]));
  }
  state.force = std::move(force);
  state.step = step;
  state.iterations = iterations;
  state.indentation = indentation;
  return state;
}

SurfaceState solve_contact_step(const ContactProblem& problem, const SliderStep& step,
                                const CellVector& start) {
  if (problem.friction.adhesion.pulls()) {
    AdhesiveStart apart = far_apart(problem);
    apart.force = start;
    return step.load.kind == LoadKind::force ? adhesive_contact_at_force(problem, step, apart)
                                             : relaxed_contact(problem, step, apart);
  }
  if (step.load.kind == LoadKind::force && step.load.value <= 0) {
    return surface_state(problem, step, CellVector(start.size(), 0.0), problem.least_free_gap(), 0);
  }
  ContactNewton newton;
  Iterate iterate{start, mean_indentation(problem, start)};
  if (!newton.solve(problem, step, iterate, Patience::much)) {
    iterate = solve_by_growing_loads(problem, step);
  }
  return surface_state(problem, step, std::move(iterate.force), iterate.indentation,
                       newton.iterations());
}

} // namespace ionskin::mechanics
