// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/surface/adhesion_energy.hpp"

#include "ionskin/mechanics/surface/adhesive_contact.hpp"

#include <numeric>

namespace ionskin::mechanics {

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
