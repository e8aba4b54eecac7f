// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/surface/adhesive_contact.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/mechanics/surface/contact_newton.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace ionskin::mechanics {
namespace {

constexpr int most_relaxations = 3000; ///< largest number of updates of the pulls
/// Changes of the pulls over the largest force [1]: below the first, Newton's method takes over;
/// below the second, the contact is solved.
constexpr double near_change = 0.02, relaxed_change = 1e-10;
constexpr int relaxations_between = 10; ///< updates between attempts by Newton's method
/// Largest change of the normal forces by Newton's method, over the sum of the forces [1]; a larger
/// one means that it went to another solution.
constexpr double most_moved = 0.2;

[[noreturn]] void give_up_adhesion(double indentation) {
  throw SolverError(
      fmt::format("no solution of the adhesive contact was found at an indentation of "
                  "{:.3g} um",
                  indentation * 1e6),
      "lower contact.cohesive_strength or contact.friction, or raise numerics.mesh_refinement");
}

/// Opening between slider and surface at each cell [m].
std::vector<double> openings(const ContactProblem& problem, double indentation,
                             const CellVector& surface) {
  std::vector<double> result(problem.area.size());
  for (int cell = 0; cell < problem.cells(); ++cell) {
    result[static_cast<std::size_t>(cell)] = problem.opening(cell, indentation, surface);
  }
  return result;
}

} // namespace

double sum_of_magnitudes(const CellVector& force) {
  return std::accumulate(force.begin(), force.end(), 0.0,
                         [](double sum, double value) { return sum + std::abs(value); });
}

std::optional<SurfaceState> nearby_solution(const ContactProblem& problem, const SliderStep& step,
                                            const CellVector& start, double indentation) {
  ContactNewton newton;
  Iterate found{start, indentation};
  if (!newton.solve(problem, step, found)) {
    return std::nullopt;
  }
  double moved = 0;
  for (std::size_t at = 0; at < start.size(); at += 3) {
    moved += std::abs(found.force[at] - start[at]);
  }
  if (moved > most_moved * sum_of_magnitudes(start)) {
    return std::nullopt;
  }
  return surface_state(problem, step, std::move(found.force), found.indentation,
                       newton.iterations());
}

AdhesiveStart far_apart(const ContactProblem& problem) {
  const double indentation =
      *std::ranges::min_element(problem.gap) - problem.friction.adhesion.range;
  const CellVector none(3 * problem.area.size(), 0.0);
  return {none, openings(problem, indentation, none), indentation};
}

AdhesiveStart start_from(const ContactProblem& problem, const SurfaceState& state) {
  return {state.force, openings(problem, state.indentation, state.surface), state.indentation};
}

SurfaceState relaxed_contact(const ContactProblem& problem, const SliderStep& step,
                             const AdhesiveStart& start) {
  ContactProblem held = problem;
  ContactNewton newton;
  held.pull.resize(problem.area.size());
  std::vector<double> opening = start.opening;
  CellVector force = start.force;
  double indentation = step.load.value;
  int iterations = 0;
  for (int i = 0; i < most_relaxations; ++i) {
    double change = 0, scale = 0;
    for (std::size_t cell = 0; cell < opening.size(); ++cell) {
      const double pull = problem.area[cell] * problem.friction.adhesion.tension(opening[cell]);
      change = std::max(change, std::abs(pull - held.pull[cell]));
      held.pull[cell] = pull;
      scale = std::max({scale, pull, std::abs(force[3 * cell])});
    }
    const double relative = change / std::max(scale, 1e-300);
    if (i > 0 && (change == 0 || relative <= relaxed_change)) {
      return surface_state(problem, step, std::move(force), indentation, iterations);
    }
    if (i > 1 && (relative <= near_change || i % relaxations_between == 0)) {
      if (auto found = nearby_solution(problem, step, force, indentation)) {
        found->iterations += iterations;
        return *std::move(found);
      }
    }
    Iterate now{std::move(force), indentation};
    const bool converged = newton.solve(held, step, now);
    iterations += newton.iterations();
    if (!converged) {
      give_up_adhesion(indentation);
    }
    force = std::move(now.force);
    opening = openings(problem, indentation, problem.surface_displacement(force));
  }
  give_up_adhesion(indentation);
}

} // namespace ionskin::mechanics
