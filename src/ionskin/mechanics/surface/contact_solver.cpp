// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/surface/contact_solver.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/mechanics/surface/adhesive_contact.hpp"
#include "ionskin/mechanics/surface/contact_at_force.hpp"
#include "ionskin/mechanics/surface/contact_newton.hpp"
#include "ionskin/mechanics/surface/projected_gauss_seidel.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace ionskin::mechanics {
namespace {

constexpr double rough_tolerance = 1e-4;
constexpr int rough_sweeps = 3000;
constexpr double fallback_tolerance = 1e-10;
constexpr int fallback_sweeps = 20000;

SurfaceState solve_at_indentation(const ContactProblem& problem, const SliderStep& step,
                                  const CellVector& start) {
  double indentation = step.load.value;
  CellVector rough = start;
  const auto sweeps =
      projected_gauss_seidel(problem, step, indentation, rough, rough_tolerance, rough_sweeps);
  CellVector force = rough;
  const auto newton = contact_newton(problem, step, force, indentation);
  int iterations = sweeps.sweeps + newton.iterations;
  if (newton.converged && free_of_tension(problem, force)) {
    return surface_state(problem, step, std::move(force), indentation, iterations);
  }
  const auto fallback = projected_gauss_seidel(problem, step, indentation, rough,
                                               fallback_tolerance, fallback_sweeps);
  iterations += fallback.sweeps;
  if (!fallback.converged) {
    throw SolverError(
        fmt::format(
            "the contact solver did not converge in {} iterations at an indentation of {:.3g} um",
            iterations, indentation * 1e6),
        "lower contact.friction, or change numerics.mesh_refinement");
  }
  return surface_state(problem, step, std::move(rough), indentation, iterations);
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
    return solve_adhesive_step(problem, step, apart);
  }
  return step.load.kind == LoadKind::force ? solve_contact_at_force(problem, step, start)
                                           : solve_at_indentation(problem, step, start);
}

} // namespace ionskin::mechanics
