// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/surface/contact_problem.hpp"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>

namespace ionskin::mechanics {

double ContactProblem::own_compliance(int cell, int component) const {
  if (product) {
    return product->own()[static_cast<std::size_t>(component)];
  }
  const auto own = [&](int c) {
    const int at = 3 * cell + c;
    return compliance(at, at) - (c > 0 ? common[static_cast<std::size_t>(c) - 1] : 0.0);
  };
  return component == 0 || own(component) > 0 ? own(component) : own(3 - component);
}

bool ContactProblem::held(int cell, int component) const {
  const int at = 3 * cell + component;
  return !product && compliance(at, at) <= 0;
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

double ContactProblem::lagged_speed_of(int cell) const {
  return lagged_speed.empty() ? 0.0 : lagged_speed[static_cast<std::size_t>(cell)];
}

double ContactProblem::free_gap(int cell) const {
  return gap[cell] + (by_others.empty() ? 0.0 : by_others[3 * static_cast<std::size_t>(cell)]);
}

double ContactProblem::least_free_gap() const {
  double least = free_gap(0);
  for (int cell = 1; cell < cells(); ++cell) {
    least = std::min(least, free_gap(cell));
  }
  return least;
}

CellVector ContactProblem::surface_displacement(const CellVector& force) const {
  CellVector result = own_displacement(force);
  for (std::size_t at = 0; at < by_others.size(); ++at) {
    result[at] += by_others[at];
  }
  return result;
}

CellVector ContactProblem::own_displacement(const CellVector& force) const {
  if (product) {
    CellVector moved = product->times(force);
    for (std::size_t c = 0; c < 2 && common != std::array<double, 2>{}; ++c) {
      double sum = 0;
      for (std::size_t at = 1 + c; at < force.size(); at += 3) {
        sum += force[at];
      }
      for (std::size_t at = 1 + c; at < force.size(); at += 3) {
        moved[at] += common[c] * sum;
      }
    }
    return moved;
  }
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

laws::CellTrial ContactProblem::cell_trial(int cell, const SliderStep& step, double indentation,
                                           const CellVector& force,
                                           const CellVector& surface) const {
  const std::size_t at = 3 * static_cast<std::size_t>(cell);
  const double normal = own_compliance(cell, 0), tangential = own_compliance(cell, 1);
  const auto slip = slip_increment(step, surface, cell);
  return {
      .area = area[cell],
      .normal_compliance = normal,
      .tangential_compliance = tangential,
      .normal = force[at] - opening(cell, indentation, surface) / normal,
      .tangential = {force[at + 1] + slip[0] / tangential, force[at + 2] + slip[1] / tangential},
      .pull = largest_pull(cell),
      .pull_slope = pull_slope(cell),
      .time_step = step.time_step,
      .lagged_speed = lagged_speed_of(cell),
      .elastic = step.elastic_slip_before(cell),
      .sliding_direction = step.sliding_direction};
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

std::array<double, 2> slip_increment(const SliderStep& step, const CellVector& surface, int cell) {
  const std::size_t x = 3 * static_cast<std::size_t>(cell) + 1, y = x + 1;
  std::array<double, 2> travel = step.travel;
  if (!step.turn.empty()) {
    travel[0] += step.turn[static_cast<std::size_t>(cell)][0];
    travel[1] += step.turn[static_cast<std::size_t>(cell)][1];
  }
  return {travel[0] - (surface[x] - step.surface_before[x]),
          travel[1] - (surface[y] - step.surface_before[y])};
}

} // namespace ionskin::mechanics
