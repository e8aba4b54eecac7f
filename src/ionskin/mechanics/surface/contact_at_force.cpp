// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/surface/contact_at_force.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/mechanics/surface/contact_newton.hpp"
#include "ionskin/mechanics/surface/projected_gauss_seidel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace ionskin::mechanics {
namespace {

/// Within this part of the force Newton takes over from the guesses.
constexpr double near_force = 0.2;
constexpr int most_guesses = 30;
/// Of a guess at first, and where Newton cycles from it.
constexpr double rough_guess = 1e-2, fine_guess = 1e-4;
constexpr int guess_sweeps = 3000;
constexpr double force_tolerance = 1e-11;
constexpr int most_searches = 100;

/// Indentation at which forces would hold the touching cells on the slider's face, in the mean over
/// the force; that of a uniform pressure when there are none.
double guessed_indentation(const ContactProblem& problem, double load, const CellVector& force) {
  const double total = total_normal_force(force);
  CellVector start = force;
  if (total <= 0) {
    for (int cell = 0; cell < problem.cells(); ++cell) {
      start[3 * static_cast<std::size_t>(cell)] = load / problem.cells();
    }
  }
  const CellVector surface = problem.surface_displacement(start);
  double sum = 0;
  for (int cell = 0; cell < problem.cells(); ++cell) {
    const std::size_t at = 3 * static_cast<std::size_t>(cell);
    sum += start[at] * (surface[at] + (total > 0 ? problem.gap[cell] : 0.0));
  }
  return sum / total_normal_force(start);
}

/// Forces and indentation near the given load, for Newton to start from.
struct ForceGuess {
  CellVector force;
  double indentation = 0;
  int sweeps = 0;
};

ForceGuess guess_at_force(const ContactProblem& problem, const SliderStep& step,
                          const CellVector& start, double tolerance) {
  const double load = step.load.value;
  ForceGuess guess{start, guessed_indentation(problem, load, start), 0};
  for (int i = 0; i < most_guesses; ++i) {
    guess.sweeps += projected_gauss_seidel(problem, step, guess.indentation, guess.force, tolerance,
                                           guess_sweeps)
                        .sweeps;
    const double ratio = load / std::max(total_normal_force(guess.force), load * 1e-3);
    if (std::abs(ratio - 1) < near_force) {
      break;
    }
    // Exact for a flat slider without history; contracts for round ones, whose force grows faster.
    guess.indentation *= std::clamp(ratio, 0.3, 3.0);
  }
  return guess;
}

/// Bracketed secant search (Illinois variant of regula falsi) over the indentation.
SurfaceState search_indentation(const ContactProblem& problem, const SliderStep& step,
                                const ForceGuess& guess) {
  int iterations = guess.sweeps;
  CellVector force = guess.force;
  const auto excess = [&](double indentation, SurfaceState& state) {
    SliderStep by_height = step;
    by_height.load = {LoadKind::indentation, indentation};
    state = solve_contact_step(problem, by_height, force);
    iterations += state.iterations;
    force = state.force;
    return total_normal_force(state.force) / step.load.value - 1;
  };
  SurfaceState state;
  double low = 0, low_excess = -1, high = guess.indentation, high_excess = excess(high, state);
  for (int i = 0; high_excess < 0 && i < most_guesses; ++i) {
    low = high;
    low_excess = high_excess;
    high *= 2;
    high_excess = excess(high, state);
  }
  int last_side = 0;
  for (int i = 0; i < most_searches && high_excess >= 0; ++i) {
    const double middle = (low * high_excess - high * low_excess) / (high_excess - low_excess);
    const double value = excess(middle, state);
    if (std::abs(value) <= force_tolerance) {
      return surface_state(problem, step, std::move(state.force), middle, iterations);
    }
    const int side = value > 0 ? 1 : -1;
    (side > 0 ? high : low) = middle;
    (side > 0 ? high_excess : low_excess) = value;
    if (side == last_side) {
      (side > 0 ? low_excess : high_excess) /= 2;
    }
    last_side = side;
  }
  throw SolverError(
      fmt::format("the contact solver found no indentation that carries {:.3g} N", step.load.value),
      "lower contact.friction, or change numerics.mesh_refinement");
}

} // namespace

SurfaceState solve_contact_at_force(const ContactProblem& problem, const SliderStep& step,
                                    const CellVector& start) {
  if (step.load.value <= 0) {
    return surface_state(problem, step, CellVector(start.size(), 0.0),
                         *std::min_element(problem.gap.begin(), problem.gap.end()), 0);
  }
  ForceGuess guess{start, 0, 0};
  for (const double tolerance : {rough_guess, fine_guess}) {
    const int sweeps = guess.sweeps;
    guess = guess_at_force(problem, step, guess.force, tolerance);
    guess.sweeps += sweeps;
    CellVector force = guess.force;
    double indentation = guess.indentation;
    const auto newton = contact_newton(problem, step, force, indentation);
    if (newton.converged && free_of_tension(problem, force)) {
      return surface_state(problem, step, std::move(force), indentation,
                           guess.sweeps + newton.iterations);
    }
  }
  return search_indentation(problem, step, guess);
}

} // namespace ionskin::mechanics
