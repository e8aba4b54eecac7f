// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/path/steady_sliding.hpp"

#include "ionskin/base/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace ionskin::mechanics {
namespace {

/// Checks that the friction law gives a finite limit and slope at roughly the pressure of a load.
/// Throws SolverError if not.
void require_number(const ContactProblem& problem, const SliderLoad& load) {
  const double area = std::accumulate(problem.area.begin(), problem.area.end(), 0.0);
  const double pressure =
      (load.kind == LoadKind::force ? load.value : load.value / problem.own_compliance(0, 0)) /
      area;
  const laws::FrictionArguments at{.normal_traction = pressure};
  const double slope = problem.friction.limit_slope(at), limit = problem.friction.limit(at);
  if (!std::isfinite(slope) || !std::isfinite(limit)) {
    throw SolverError(
        fmt::format(
            "the friction law \"{}\" gives no finite number in steady sliding: its limit is "
            "{} Pa with the slope {} at a normal traction of {:.3g} Pa, where slip increment "
            "and time step are 0",
            problem.friction.law, limit, slope, pressure),
        "choose another contact.law, or let the law return what it tends to for a time step of 0");
  }
}

} // namespace

SurfaceState steady_sliding(const ContactProblem& problem, const SliderLoad& load,
                            const std::array<double, 2>& direction, double travel) {
  require_number(problem, load);
  const CellVector none(3 * problem.area.size(), 0.0);
  SliderStep step{load, {travel * direction[0], travel * direction[1]}, 0, none};
  step.sliding_direction = direction;
  SurfaceState state = solve_contact_step(problem, step, none);
  std::ranges::fill(state.slip, travel);
  state.step.surface_before = state.surface;
  state.step.sliding_direction.reset();
  return state;
}

} // namespace ionskin::mechanics
