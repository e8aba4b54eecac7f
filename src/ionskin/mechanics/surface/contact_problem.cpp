// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/surface/contact_problem.hpp"

#include <Eigen/Core>

namespace ionskin::mechanics {

double ContactProblem::own_compliance(int cell, int component) const {
  const auto own = [&](int c) {
    const int at = 3 * cell + c;
    return compliance(at, at) - (c > 0 ? common[static_cast<std::size_t>(c) - 1] : 0.0);
  };
  return component == 0 || own(component) > 0 ? own(component) : own(3 - component);
}

double ContactProblem::lagged_speed_of(int cell) const {
  return lagged_speed.empty() ? 0.0 : lagged_speed[static_cast<std::size_t>(cell)];
}

CellVector ContactProblem::surface_displacement(const CellVector& force) const {
  CellVector result(force.size());
  const Eigen::Map<const Eigen::MatrixXd> matrix(compliance.values.data(), compliance.rows,
                                                 compliance.columns);
  Eigen::Map<Eigen::VectorXd>(result.data(), compliance.rows).noalias() =
      matrix * Eigen::Map<const Eigen::VectorXd>(force.data(), compliance.rows);
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
                                                         double own_slip, double time_step,
                                                         bool slips) const {
  const double cell_area = area[cell];
  laws::FrictionResponse response =
      laws::return_mapping(friction,
                           {normal_force / cell_area,
                            {trial[0] / cell_area, trial[1] / cell_area},
                            own_slip * cell_area,
                            time_step,
                            lagged_speed_of(cell)},
                           slips);
  for (double& component : response.traction) {
    component *= cell_area;
  }
  return response;
}

double total_normal_force(const CellVector& force) {
  double sum = 0;
  for (std::size_t at = 0; at < force.size(); at += 3) {
    sum += force[at];
  }
  return sum;
}

bool free_of_tension(const CellVector& force) {
  for (std::size_t at = 0; at < force.size(); at += 3) {
    if (force[at] < 0) {
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
