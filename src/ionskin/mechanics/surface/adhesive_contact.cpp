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

constexpr int most_relaxations = 3000;
/// Change of the pulls over the largest force: below the first Newton finishes, below the second
/// nothing is left to do.
constexpr double near_change = 0.02, relaxed_change = 1e-10;
constexpr int relaxations_between = 10; ///< attempts of Newton
/// Newton may move the forces by so much of their sum, or it has gone elsewhere.
constexpr double most_moved = 0.2;
constexpr int most_heights = 200;
constexpr double first_way = 0.25; ///< of the range of the adhesion, towards a force
constexpr double longest_growth = 2;
constexpr double balance_tolerance = 1e-10; ///< of the sum of the cells' forces
/// A way up that is halved below this, of the range, ends in a jump.
constexpr double shortest_way = 1e-4;

[[noreturn]] void give_up_adhesion(double indentation) {
  throw SolverError(
      fmt::format("the adhesive contact has no solution that was found at an indentation of "
                  "{:.3g} um",
                  indentation * 1e6),
      "lower contact.cohesive_strength or contact.friction, or raise numerics.mesh_refinement");
}

std::vector<double> openings(const ContactProblem& problem, double indentation,
                             const CellVector& surface) {
  std::vector<double> result(problem.area.size());
  for (int cell = 0; cell < problem.cells(); ++cell) {
    result[static_cast<std::size_t>(cell)] = problem.opening(cell, indentation, surface);
  }
  return result;
}

double sum_of_magnitudes(const CellVector& force) {
  return std::accumulate(force.begin(), force.end(), 0.0,
                         [](double sum, double value) { return sum + std::abs(value); });
}

/// Newton with the pulls as the law has them, where it stays near and the result can last.
bool finished(const ContactProblem& problem, const SliderStep& step, CellVector& force,
              double& indentation, int& iterations) {
  ContactNewton newton;
  Iterate found{force, indentation};
  const bool converged = newton.solve(problem, step, found);
  iterations += newton.iterations();
  if (!converged) {
    return false;
  }
  double moved = 0;
  for (std::size_t at = 0; at < force.size(); at += 3) {
    moved += std::abs(found.force[at] - force[at]);
  }
  if (moved > most_moved * sum_of_magnitudes(force)) {
    return false;
  }
  force = std::move(found.force);
  indentation = found.indentation;
  return true;
}

SurfaceState relaxed(const ContactProblem& problem, const SliderStep& step,
                     const AdhesiveStart& start) {
  ContactProblem held = problem;
  ContactNewton newton;
  held.pull.resize(problem.area.size());
  std::vector<double> opening = start.opening;
  CellVector force = start.force;
  double indentation = step.load.value;
  int iterations = 0;
  for (int i = 0; i < most_relaxations; ++i) {
    double change = 0;
    for (std::size_t cell = 0; cell < opening.size(); ++cell) {
      const double pull = problem.area[cell] * problem.friction.adhesion.tension(opening[cell]);
      change = std::max(change, std::abs(pull - held.pull[cell]));
      held.pull[cell] = pull;
    }
    const double scale =
        *std::ranges::max_element(force, {}, [](double value) { return std::abs(value); });
    const double relative = change / std::max(std::abs(scale), 1e-300);
    if (i > 0 && (change == 0 || relative <= relaxed_change)) {
      return surface_state(problem, step, std::move(force), indentation, iterations);
    }
    if (i > 1 && (relative <= near_change || i % relaxations_between == 0) &&
        finished(problem, step, force, indentation, iterations)) {
      return surface_state(problem, step, std::move(force), indentation, iterations);
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

/// Moves the slider until it carries a force.
class ForceSearch {
public:
  ForceSearch(const ContactProblem& problem, const SliderStep& step)
      : problem_(problem), step_(step), range_(problem.friction.adhesion.range) {}

  SurfaceState from(const AdhesiveStart& start) {
    SurfaceState here = at(start.indentation, start);
    const double side = excess(here) > 0 ? -1 : 1; // up where it presses too hard
    double way = first_way * range_;
    for (int i = 0; i < most_heights; ++i) {
      SurfaceState next = at(here.indentation + side * way, start_from(problem_, here));
      if (excess(next) == 0 || (excess(next) > 0) != (excess(here) > 0)) {
        const bool came_off = side < 0 && sum_of_magnitudes(next.force) == 0;
        if (!came_off || way <= shortest_way * range_) {
          return came_off ? next : between(std::move(here), std::move(next));
        }
        way /= 2;
        continue;
      }
      if (side < 0 && sum_of_magnitudes(next.force) == 0) {
        if (way <= shortest_way * range_) {
          return next; // it comes off before it pulls so hard
        }
        way /= 2;
        continue;
      }
      const double slope = (excess(next) - excess(here)) / (side * way);
      const double left = slope > 0 ? std::abs(excess(next)) / slope : longest_growth * way;
      way = std::min(longest_growth * way, std::max(1.05 * left, shortest_way * range_));
      here = std::move(next);
    }
    throw SolverError(fmt::format("the adhesive contact carries {:.3g} N at no height that was "
                                  "tried",
                                  step_.load.value),
                      "give heights in place of forces");
  }

private:
  SliderStep height(double indentation) const {
    SliderStep step = step_;
    step.load = {LoadKind::indentation, indentation};
    return step;
  }
  double excess(const SurfaceState& state) const {
    return total_normal_force(state.force) - step_.load.value;
  }
  SurfaceState at(double indentation, const AdhesiveStart& start) const {
    CellVector force = start.force;
    double found = indentation;
    int iterations = 0;
    if (finished(problem_, height(indentation), force, found, iterations)) {
      return surface_state(problem_, height(indentation), std::move(force), found, iterations);
    }
    return relaxed(problem_, height(indentation), start);
  }
  /// Illinois variant of regula falsi; Newton at last.
  SurfaceState between(SurfaceState a, SurfaceState b) const {
    double excess_a = excess(a), excess_b = excess(b);
    int last_side = 0, iterations = a.iterations + b.iterations;
    for (int i = 0; i < most_heights; ++i) {
      CellVector force = a.force;
      double indentation = a.indentation;
      const double low = std::min(a.indentation, b.indentation);
      const double high = std::max(a.indentation, b.indentation);
      if (finished(problem_, step_, force, indentation, iterations) && indentation >= low &&
          indentation <= high) {
        return surface_state(problem_, step_, std::move(force), indentation, iterations);
      }
      const double middle =
          (a.indentation * excess_b - b.indentation * excess_a) / (excess_b - excess_a);
      SurfaceState next = at(middle, start_from(problem_, a));
      const double off = excess(next);
      if (std::abs(off) <= balance_tolerance * sum_of_magnitudes(next.force) ||
          high - low < 1e-18) {
        next.step = step_;
        return next;
      }
      const int side = (off > 0) == (excess_a > 0) ? 1 : -1;
      if (side > 0) {
        a = std::move(next);
        excess_a = off;
        excess_b /= last_side == side ? 2 : 1;
      } else {
        b = std::move(next);
        excess_b = off;
        excess_a /= last_side == side ? 2 : 1;
      }
      last_side = side;
    }
    give_up_adhesion(a.indentation);
  }

  const ContactProblem& problem_;
  const SliderStep& step_;
  double range_;
};

} // namespace

AdhesiveStart far_apart(const ContactProblem& problem) {
  const double indentation =
      *std::ranges::min_element(problem.gap) - problem.friction.adhesion.range;
  const CellVector none(3 * problem.area.size(), 0.0);
  return {none, openings(problem, indentation, none), indentation};
}

AdhesiveStart start_from(const ContactProblem& problem, const SurfaceState& state) {
  return {state.force, openings(problem, state.indentation, state.surface), state.indentation};
}

SurfaceState solve_adhesive_step(const ContactProblem& problem, const SliderStep& step,
                                 const AdhesiveStart& start) {
  if (step.load.kind == LoadKind::indentation) {
    return relaxed(problem, step, start);
  }
  return ForceSearch(problem, step).from(start);
}

double binding_energy(const ContactProblem& problem, const SurfaceState& state) {
  double energy = 0;
  for (int cell = 0; cell < problem.cells() && problem.friction.adhesion.pulls(); ++cell) {
    energy += problem.area[static_cast<std::size_t>(cell)] *
              problem.friction.adhesion.binding_energy(
                  problem.opening(cell, state.indentation, state.surface));
  }
  return energy;
}

double potential_energy(const ContactProblem& problem, const SurfaceState& state) {
  const double elastic =
      0.5 * std::inner_product(state.force.begin(), state.force.end(), state.surface.begin(), 0.0);
  return elastic - binding_energy(problem, state);
}

double work_on_skin(const SurfaceState& before, const SurfaceState& after, double lowered) {
  const bool both = sum_of_magnitudes(before.force) > 0 && sum_of_magnitudes(after.force) > 0;
  const double down = both ? after.indentation - before.indentation : lowered;
  double work = 0;
  for (std::size_t at = 0; at < after.force.size(); ++at) {
    const double way = at % 3 == 0 ? down : after.surface[at] - before.surface[at];
    work += 0.5 * (before.force[at] + after.force[at]) * way;
  }
  return work;
}

} // namespace ionskin::mechanics
