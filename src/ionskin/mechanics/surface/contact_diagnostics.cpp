// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/surface/contact_diagnostics.hpp"

#include "ionskin/base/largest.hpp"

#include <algorithm>
#include <cmath>

namespace ionskin::mechanics {

namespace {

/// Quotient of two numbers; 0 for 0 / 0, as without a contact.
double share(double part, double whole) {
  return part == 0 ? 0 : part / whole;
}

} // namespace

double ContactViolations::largest() const {
  return base::nan_max(base::nan_max(tension, penetration), base::nan_max(cone, slip_law));
}

ContactViolations contact_violations(const ContactProblem& problem, const SurfaceState& state,
                                     double reference_force, double preload) {
  const SliderStep& step = state.step;
  ContactViolations worst;
  for (int cell = 0; cell < problem.cells(); ++cell) {
    const std::size_t at = 3 * static_cast<std::size_t>(cell);
    const double normal = state.force[at];
    const double opening = problem.opening(cell, state.indentation, state.surface);
    const laws::CellTrial trial =
        problem.cell_trial(cell, step, state.indentation, state.force, state.surface);
    const laws::CellResponse held = laws::cell_response(problem.friction, trial);
    const bool adheres = problem.friction.adhesion.pulls();
    const bool touches = adheres ? held.normal_by_trial == 1 : normal > 0;
    const double pull = adheres ? std::abs(normal - held.normal) : -normal;
    worst.tension = base::nan_max(worst.tension, share(pull, reference_force));
    const double gap = share(opening, preload);
    worst.penetration = base::nan_max(worst.penetration, touches ? std::abs(gap) : -gap);

    const auto slip = slip_increment(step, state.surface, cell);
    const double limit = problem.friction_limit_behind(cell, normal, slip, step);
    const std::array<double, 2> force{state.force[at + 1], state.force[at + 2]};
    worst.cone = base::nan_max(
        worst.cone, share(laws::limit_norm(problem.friction, force) - limit, reference_force));
    const auto allowed = laws::cell_friction(problem.friction, trial, normal).traction;
    worst.slip_law = base::nan_max(
        worst.slip_law,
        share(std::hypot(force[0] - allowed[0], force[1] - allowed[1]), reference_force));
  }
  return worst;
}

// Stored energy is computed from the present traction, not from the elastic slip behind it.
FrictionEnergy friction_energy(const ContactProblem& problem, const SurfaceState& state) {
  const laws::Friction& friction = problem.friction;
  FrictionEnergy energy;
  for (int cell = 0; cell < problem.cells(); ++cell) {
    const std::size_t at = 3 * static_cast<std::size_t>(cell);
    const std::array<double, 2> force{state.force[at + 1], state.force[at + 2]};
    double before = 0, behind = 0;
    if (friction.elastic_slip > 0) {
      const double limit = problem.friction_limit(cell, state.force[at], friction.elastic_slip,
                                                  state.step.time_step);
      before =
          problem.area[cell] * laws::stored_energy(friction, state.step.elastic_slip_before(cell));
      behind = limit > 0 ? 0.5 * friction.elastic_slip / limit *
                               (force[0] * force[0] + force[1] * force[1])
                         : 0.0;
    }
    const auto slip = slip_increment(state.step, state.surface, cell);
    const double work = force[0] * slip[0] + force[1] * slip[1];
    energy.stored += behind;
    energy.created += std::max(0.0, behind - before - work);
  }
  return energy;
}

std::vector<double> stick_reserve(const ContactProblem& problem, const CellVector& force) {
  std::vector<double> reserve(problem.area.size(), 0.0);
  for (int cell = 0; cell < problem.cells(); ++cell) {
    const std::size_t at = 3 * static_cast<std::size_t>(cell);
    if (force[at] > 0) {
      const double limit = problem.friction_limit(cell, force[at], 0, 0);
      const double left =
          limit - laws::limit_norm(problem.friction, {force[at + 1], force[at + 2]});
      reserve[cell] = left > limit * 1e-9 ? left / problem.area[cell] : 0.0;
    }
  }
  return reserve;
}

double stick_fraction(const ContactProblem& problem, const CellVector& force) {
  const std::vector<double> reserve = stick_reserve(problem, force);
  double touching = 0, sticking = 0;
  for (std::size_t cell = 0; cell < reserve.size(); ++cell) {
    touching += force[3 * cell] > 0 ? problem.area[cell] : 0.0;
    sticking += reserve[cell] > 0 ? problem.area[cell] : 0.0;
  }
  return touching > 0 ? sticking / touching : 0.0;
}

} // namespace ionskin::mechanics
