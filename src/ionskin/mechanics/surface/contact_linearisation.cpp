// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/surface/contact_linearisation.hpp"

#include "ionskin/base/largest.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ionskin::mechanics {

CellPredictor predict(const ContactProblem& problem, const SliderStep& step, const Iterate& iterate,
                      const CellVector& surface, int cell) {
  const std::size_t at = 3 * static_cast<std::size_t>(cell);
  const CellVector& force = iterate.force;
  CellPredictor result;
  const double normal = force[at] + (iterate.indentation - problem.gap[cell] - surface[at]) /
                                        problem.own_compliance(cell, 0);
  const ContactProblem::NormalResponse held = problem.normal_response(cell, normal);
  result.residual = std::isnan(normal) ? normal : std::abs(force[at] - held.force);
  if (!held.touches) {
    result.status = held.pulled ? CellStatus::pulled : CellStatus::separated;
    result.residual = base::larger(result.residual,
                                   base::larger(std::abs(force[at + 1]), std::abs(force[at + 2])));
    return result;
  }
  const auto slip = slip_increment(step, surface, cell);
  const double compliance = problem.own_compliance(cell, 1);
  result.tangential = {force[at + 1] + slip[0] / compliance, force[at + 2] + slip[1] / compliance};
  const laws::FrictionResponse response =
      problem.friction_response(cell, normal, result.tangential, compliance, step);
  result.status = response.sticks ? CellStatus::sticking : CellStatus::slipping;
  const auto& allowed = response.traction;
  result.residual =
      base::larger(result.residual, base::larger(std::abs(force[at + 1] - allowed[0]),
                                                 std::abs(force[at + 2] - allowed[1])));
  return result;
}

LinearSystem::LinearSystem(const ContactProblem& problem, const SliderStep& step,
                           const std::vector<int>& touching)
    : problem_(problem), step_(step), touching_(touching),
      matrix_(Eigen::MatrixXd::Zero(size(), size())), right_(Eigen::VectorXd::Zero(size())) {}

void LinearSystem::add_load_row() {
  if (!force_given()) {
    return;
  }
  for (int i = 0; i < count(); ++i) {
    matrix_(size() - 1, 3 * i) = 1;
  }
  right_[size() - 1] = step_.load.value;
}

void LinearSystem::add_opening(int i, double scale) {
  add_displacement(3 * i, 3 * touching_[i], scale);
  right_[3 * i] -= scale * problem_.gap[touching_[i]];
  if (force_given()) {
    matrix_(3 * i, size() - 1) -= scale;
  } else {
    right_[3 * i] += scale * step_.load.value;
  }
}

void LinearSystem::add_normal_row(int i) {
  add_opening(i, 1 / problem_.own_compliance(touching_[i], 0));
}

void LinearSystem::add_pulled_rows(int i) {
  add_opening(i, -problem_.pull_slope(touching_[i]));
  right_[3 * i] -= problem_.largest_pull(touching_[i]);
  for (int c = 0; c < 3; ++c) {
    matrix_(3 * i + c, 3 * i + c) += 1;
  }
}

void LinearSystem::add_stick_rows(int i) {
  const int cell = touching_[i];
  const double scale = 1 / problem_.own_compliance(cell, 1);
  for (int c = 1; c < 3; ++c) {
    if (problem_.compliance(3 * cell + c, 3 * cell + c) > 0) {
      add_displacement(3 * i + c, 3 * cell + c, scale);
      right_[3 * i + c] = scale * free_displacement(cell, c);
    } else { // held by the skin itself: no tangential force arises
      matrix_(3 * i + c, 3 * i + c) = 1;
    }
  }
}

void LinearSystem::add_slip_rows(int i, const CellPredictor& predictor, double normal_force) {
  const int cell = touching_[i];
  const double compliance = problem_.own_compliance(cell, 1), scale = 1 / compliance;
  const laws::FrictionResponse friction =
      problem_.friction_response(cell, normal_force, predictor.tangential, compliance, step_, true);
  for (int r = 0; r < 2; ++r) {
    const int row = 3 * i + 1 + r;
    matrix_(row, row) += 1;
    matrix_(row, 3 * i) -= friction.by_normal[r];
    right_[row] += friction.traction[r] - friction.by_normal[r] * normal_force;
    for (int s = 0; s < 2; ++s) {
      const double weight = friction.by_trial[r][s];
      add_displacement(row, 3 * cell + 1 + s, weight * scale);
      matrix_(row, 3 * i + 1 + s) -= weight;
      right_[row] += weight * (scale * free_displacement(cell, 1 + s) - predictor.tangential[s]);
    }
  }
}

void LinearSystem::add_rows(const std::vector<CellPredictor>& predictors, const Iterate& iterate) {
  add_load_row();
  for (int i = 0; i < count(); ++i) {
    const auto cell = static_cast<std::size_t>(touching_[i]);
    const CellPredictor& predictor = predictors[cell];
    if (predictor.status == CellStatus::pulled) {
      add_pulled_rows(i);
      continue;
    }
    add_normal_row(i);
    if (predictor.status == CellStatus::sticking) {
      add_stick_rows(i);
    } else {
      add_slip_rows(i, predictor, std::max(0.0, iterate.force[3 * cell]));
    }
  }
}

bool has_positive_determinant(const Eigen::PartialPivLU<Eigen::MatrixXd>& factor) {
  bool positive = factor.permutationP().determinant() > 0;
  for (const double pivot : factor.matrixLU().diagonal()) {
    positive = positive == (pivot > 0);
  }
  return positive;
}

void LinearSystem::solve(Iterate& iterate) const {
  const Eigen::VectorXd solution = matrix_.partialPivLu().solve(right_);
  std::fill(iterate.force.begin(), iterate.force.end(), 0.0);
  for (int i = 0; i < count(); ++i) {
    for (int c = 0; c < 3; ++c) {
      iterate.force[3 * touching_[i] + c] = solution[3 * i + c];
    }
  }
  if (force_given()) {
    iterate.indentation = solution[size() - 1];
  }
}

void LinearSystem::add_displacement(int row, int component, double scale) {
  const double* column = problem_.compliance.col(component).data(); // symmetric
  for (int j = 0; j < count(); ++j) {
    for (int c = 0; c < 3; ++c) {
      matrix_(row, 3 * j + c) += scale * column[3 * touching_[j] + c];
    }
  }
}

double LinearSystem::free_displacement(int cell, int c) const {
  return step_.travel[c - 1] + step_.surface_before[3 * cell + c];
}

} // namespace ionskin::mechanics
