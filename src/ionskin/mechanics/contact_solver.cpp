// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/contact_solver.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/mechanics/contact_newton.hpp"
#include "ionskin/mechanics/projected_gauss_seidel.hpp"

#include <fmt/format.h>

#include <cmath>

namespace ionskin::mechanics {
namespace {

constexpr double newton_tolerance = 1e-10;
constexpr int newton_iterations = 15;
constexpr double rough_tolerance = 1e-4;
constexpr int rough_sweeps = 3000;
constexpr double fallback_tolerance = 1e-10;
constexpr int fallback_sweeps = 20000;

bool no_tension(const CellVector& force) {
  for (std::size_t i = 0; i < force.size(); i += 3) {
    if (force[i] < 0) {
      return false;
    }
  }
  return true;
}

SurfaceState finished(const ContactProblem& problem, const SliderStep& step, CellVector force,
                      int iterations) {
  SurfaceState state;
  state.surface = problem.surface_displacement(force);
  for (int cell = 0; cell < problem.cells(); ++cell) {
    const auto slip = slip_increment(step, state.surface, cell);
    state.slip.push_back(std::hypot(slip[0], slip[1]));
  }
  state.force = std::move(force);
  state.step = step;
  state.iterations = iterations;
  return state;
}

} // namespace

SurfaceState solve_contact_step(const ContactProblem& problem, const SliderStep& step,
                                const CellVector& start) {
  CellVector rough = start;
  const auto sweeps = projected_gauss_seidel(problem, step, rough, rough_tolerance, rough_sweeps);
  CellVector force = rough;
  const auto newton = contact_newton(problem, step, force, newton_tolerance, newton_iterations);
  int iterations = sweeps.sweeps + newton.iterations;
  if (newton.converged && no_tension(force)) {
    return finished(problem, step, std::move(force), iterations);
  }
  const auto fallback =
      projected_gauss_seidel(problem, step, rough, fallback_tolerance, fallback_sweeps);
  iterations += fallback.sweeps;
  if (!fallback.converged) {
    throw SolverError(
        fmt::format(
            "the contact solver did not converge in {} iterations at an indentation of {:.3g} um",
            iterations, step.indentation * 1e6),
        "lower contact.friction, or change numerics.mesh_refinement");
  }
  return finished(problem, step, std::move(rough), iterations);
}

} // namespace ionskin::mechanics
