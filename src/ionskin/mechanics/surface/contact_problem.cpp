// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/surface/contact_problem.hpp"

#include <Eigen/Core>

#include <cmath>

namespace ionskin::mechanics {

double ContactProblem::own_compliance(int cell, int component) const {
  const auto own = [&](int c) {
    const int at = 3 * cell + c;
    return compliance(at, at) - (c > 0 ? common[static_cast<std::size_t>(c) - 1] : 0.0);
  };
  return component == 0 || own(component) > 0 ? own(component) : own(3 - component);
}

double ContactProblem::opening(int cell, double indentation, const CellVector& surface) const {
  return surface[3 * static_cast<std::size_t>(cell)] + gap[cell] - indentation;
}

double ContactProblem::largest_pull(int cell) const {
  return pull.empty() ? friction.adhesion.strength * area[cell] : pull[cell];
}

double ContactProblem::pull_slope(int cell) const {
  return pull.empty() && friction.adhesion.pulls() ? largest_pull(cell) / friction.adhesion.range
                                                   : 0.0;
}

ContactProblem::NormalResponse ContactProblem::normal_response(int cell, double trial) const {
  const double most = largest_pull(cell);
  if (trial > -most) {
    return {true, false, trial};
  }
  if (most == 0) {
    return {};
  }
  const double softening = pull_slope(cell) * own_compliance(cell, 0);
  if (softening == 0) {
    return {false, true, -most};
  }
  // The opening that balances the pull, docs/model.md (42); with a softening of 1 there is none.
  const bool far = trial <= -friction.adhesion.range / own_compliance(cell, 0);
  if (far || softening >= 1) {
    return {};
  }
  return {false, true, -(most + softening * trial) / (1 - softening)};
}

double ContactProblem::lagged_speed_of(int cell) const {
  return lagged_speed.empty() ? 0.0 : lagged_speed[static_cast<std::size_t>(cell)];
}

CellVector ContactProblem::surface_displacement(const CellVector& force) const {
  CellVector result(force.size());
  Eigen::Map<Eigen::VectorXd>(result.data(), compliance.rows()).noalias() =
      compliance * Eigen::Map<const Eigen::VectorXd>(force.data(), compliance.rows());
  return result;
}

double ContactProblem::friction_limit(int cell, double normal_force, double slip,
                                      double time_step) const {
  return area[cell] *
         friction.limit({normal_force / area[cell], slip, time_step, lagged_speed_of(cell)});
}

double ContactProblem::friction_limit_slope(int cell, double normal_force, double slip,
                                            double time_step) const {
  return friction.limit_slope({normal_force / area[cell], slip, time_step, lagged_speed_of(cell)});
}

laws::FrictionResponse ContactProblem::friction_response(int cell, double normal_force,
                                                         const std::array<double, 2>& trial,
                                                         double own_slip, const SliderStep& step,
                                                         bool slips) const {
  const double cell_area = area[cell];
  laws::FrictionResponse response =
      laws::return_mapping(friction,
                           {normal_force / cell_area,
                            {trial[0] / cell_area, trial[1] / cell_area},
                            own_slip * cell_area,
                            step.time_step,
                            lagged_speed_of(cell),
                            step.elastic_slip_before(cell)},
                           slips);
  for (double& component : response.traction) {
    component *= cell_area;
  }
  return response;
}

laws::FrictionArguments ContactProblem::arguments(int cell, double normal_force,
                                                  const SliderStep& step) const {
  return {normal_force / area[cell], 0, step.time_step, lagged_speed_of(cell)};
}

double ContactProblem::friction_limit_behind(int cell, double normal_force,
                                             const std::array<double, 2>& slip,
                                             const SliderStep& step) const {
  const auto seen = laws::slip_of_limit(friction, step.elastic_slip_before(cell),
                                        arguments(cell, normal_force, step), slip);
  return friction_limit(cell, normal_force, std::hypot(seen[0], seen[1]), step.time_step);
}

laws::SlipDivision ContactProblem::divided_slip(int cell, double normal_force,
                                                const std::array<double, 2>& slip,
                                                const SliderStep& step) const {
  return laws::divided_slip(friction, step.elastic_slip_before(cell),
                            arguments(cell, normal_force, step), slip);
}

double total_normal_force(const CellVector& force) {
  double sum = 0;
  for (std::size_t at = 0; at < force.size(); at += 3) {
    sum += force[at];
  }
  return sum;
}

bool free_of_tension(const ContactProblem& problem, const CellVector& force) {
  for (int cell = 0; cell < problem.cells(); ++cell) {
    if (force[3 * static_cast<std::size_t>(cell)] < -problem.largest_pull(cell)) {
      return false;
    }
  }
  return true;
}

std::array<double, 2> slip_increment(const SliderStep& step, const CellVector& surface, int cell) {
  const std::size_t x = 3 * static_cast<std::size_t>(cell) + 1, y = x + 1;
  return {step.travel[0] - (surface[x] - step.surface_before[x]),
          step.travel[1] - (surface[y] - step.surface_before[y])};
}

} // namespace ionskin::mechanics
