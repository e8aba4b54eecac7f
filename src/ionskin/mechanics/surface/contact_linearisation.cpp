// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/surface/contact_linearisation.hpp"

#include "ionskin/base/largest.hpp"
#include "ionskin/mechanics/surface/gmres.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace ionskin::mechanics {

using laws::CellResponse;
using laws::CellStatus;
using laws::CellTrial;

ContactEvaluation::ContactEvaluation(const ContactProblem& problem, const SliderStep& step,
                                     const Iterate& iterate)
    : surface(problem.surface_displacement(iterate.force)) {
  if (step.load.kind == LoadKind::force) {
    residual = std::abs(total_normal_force(iterate.force) - step.load.value);
  }
  for (int cell = 0; cell < problem.cells(); ++cell) {
    const double* force = iterate.force.data() + 3 * static_cast<std::ptrdiff_t>(cell);
    trial.push_back(problem.cell_trial(cell, step, iterate.indentation, iterate.force, surface));
    response.push_back(laws::cell_response(problem.friction, trial.back()));
    const CellResponse& now = response.back();
    status.push_back(now.status);
    residual = base::nan_max(residual, std::abs(force[0] - now.normal));
    for (std::size_t c = 0; c < 2; ++c) {
      residual = base::nan_max(residual, std::abs(force[1 + c] - now.tangential.traction[c]));
    }
    largest_force = std::max({largest_force, std::abs(force[0]), trial.back().pull});
    if (now.status != CellStatus::separated) {
      active.push_back(cell);
    }
  }
}

ContactLinearisation::ContactLinearisation(const ContactProblem& problem, const SliderStep& step,
                                           const ContactEvaluation& at)
    : problem_(problem), step_(step), at_(at) {
  for (const int cell : at_.active) {
    first_.push_back(size_);
    size_ += follows(cell) ? 1 : 3;
    sticks_ = sticks_ || (at_.status[cell] == CellStatus::sticking && !follows(cell));
  }
  size_ += force_given() ? 1 : 0;
}

bool ContactLinearisation::follows(int cell) const {
  return at_.status[cell] == CellStatus::pulled || step_.sliding_direction ||
         problem_.friction.coefficient == 0;
}

void ContactLinearisation::displacement_by(int i, int component, Eigen::VectorXd& result) const {
  const int cell = at_.active[i];
  result = problem_.compliance.col(3 * cell + component);
  if (follows(cell)) {
    const laws::FrictionResponse& friction = at_.response[cell].tangential;
    for (int c = 0; c < 2; ++c) {
      if (friction.by_normal[c] != 0) {
        result += friction.by_normal[c] * problem_.compliance.col(3 * cell + 1 + c);
      }
    }
  }
}

void ContactLinearisation::equations_by_surface(int i, const double* moved, double* row) const {
  const int cell = at_.active[i];
  const CellTrial& trial = at_.trial[cell];
  const bool pulled = at_.status[cell] == CellStatus::pulled;
  row[0] = pulled ? -trial.pull_slope * moved[0] : moved[0] / trial.normal_compliance;
  if (!follows(cell)) {
    const auto& by_trial = at_.response[cell].tangential.by_trial;
    const double x = moved[1] / trial.tangential_compliance,
                 y = moved[2] / trial.tangential_compliance;
    row[1] = by_trial[0][0] * x + by_trial[0][1] * y;
    row[2] = by_trial[1][0] * x + by_trial[1][1] * y;
  }
}

Eigen::MatrixXd ContactLinearisation::matrix() const {
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(size_, size_);
  const int count = static_cast<int>(at_.active.size());
  Eigen::VectorXd surface; // displacement by a unit of one unknown
  for (int j = 0; j < count; ++j) {
    for (int s = 0; s < (follows(at_.active[j]) ? 1 : 3); ++s) {
      displacement_by(j, s, surface);
      double* column = matrix.col(first_[j] + s).data();
      for (int i = 0; i < count; ++i) {
        equations_by_surface(i, surface.data() + 3 * static_cast<std::ptrdiff_t>(at_.active[i]),
                             column + first_[i]);
      }
    }
  }
  for (int i = 0; i < count; ++i) {
    const int cell = at_.active[i];
    const Eigen::Index first = first_[i];
    const CellResponse& response = at_.response[cell];
    if (response.status == CellStatus::pulled) {
      matrix(first, first) += 1;
    }
    for (int r = 0; r < 2 && !follows(cell); ++r) {
      matrix(first + 1 + r, first) -= response.tangential.by_normal[r];
      for (int s = 0; s < 2; ++s) {
        matrix(first + 1 + r, first + 1 + s) += own_tangential(cell, r, s);
      }
    }
    if (force_given()) {
      matrix(first, size_ - 1) = by_indentation(cell);
      matrix(size_ - 1, first) = 1;
    }
  }
  return matrix;
}

/// Derivative of a cell's tangential equation r by its own tangential force s. Where the skin is
/// held along s, the force does not change the trial force.
double ContactLinearisation::own_tangential(int cell, int r, int s) const {
  const double by_trial =
      problem_.held(cell, 1 + s) ? 0.0 : at_.response[cell].tangential.by_trial[r][s];
  return (r == s ? 1.0 : 0.0) - by_trial;
}

double ContactLinearisation::by_indentation(int cell) const {
  const CellTrial& trial = at_.trial[cell];
  return at_.status[cell] == CellStatus::pulled ? trial.pull_slope : -1 / trial.normal_compliance;
}

Eigen::VectorXd ContactLinearisation::times(const Eigen::VectorXd& change) const {
  const int count = static_cast<int>(at_.active.size());
  CellVector force(3 * problem_.area.size(), 0.0);
  for (int i = 0; i < count; ++i) {
    const int cell = at_.active[i];
    double* own = force.data() + 3 * static_cast<std::ptrdiff_t>(cell);
    own[0] = change[first_[i]];
    for (int c = 0; c < 2; ++c) {
      own[1 + c] = follows(cell) ? at_.response[cell].tangential.by_normal[c] * own[0]
                                 : change[first_[i] + 1 + c];
    }
  }
  const CellVector surface = problem_.own_displacement(force);
  Eigen::VectorXd result = Eigen::VectorXd::Zero(size_);
  for (int i = 0; i < count; ++i) {
    const int cell = at_.active[i];
    const Eigen::Index first = first_[i];
    equations_by_surface(i, surface.data() + 3 * static_cast<std::ptrdiff_t>(cell),
                         result.data() + first);
    if (at_.status[cell] == CellStatus::pulled) {
      result[first] += change[first];
    }
    for (int r = 0; r < 2 && !follows(cell); ++r) {
      result[first + 1 + r] -= at_.response[cell].tangential.by_normal[r] * change[first];
      for (int s = 0; s < 2; ++s) {
        result[first + 1 + r] += own_tangential(cell, r, s) * change[first + 1 + s];
      }
    }
    if (force_given()) {
      result[first] += by_indentation(cell) * change[size_ - 1];
      result[size_ - 1] += change[first];
    }
  }
  return result;
}

/// Approximate normal forces on the active cells that cause given normal displacements there, and
/// no displacement of the other cells.
Eigen::VectorXd ContactLinearisation::pressed_by(const Eigen::VectorXd& displacement) const {
  CellVector values(3 * problem_.area.size(), 0.0);
  for (std::size_t i = 0; i < at_.active.size(); ++i) {
    values[3 * static_cast<std::size_t>(at_.active[i])] = displacement[static_cast<int>(i)];
  }
  problem_.product->invert_normal(values);
  Eigen::VectorXd result(displacement.size());
  for (std::size_t i = 0; i < at_.active.size(); ++i) {
    result[static_cast<int>(i)] = values[3 * static_cast<std::size_t>(at_.active[i])];
  }
  return result;
}

Eigen::VectorXd ContactLinearisation::about_inverse(const Eigen::VectorXd& right) const {
  const int count = static_cast<int>(at_.active.size());
  Eigen::VectorXd moved(count), result(size_);
  for (int i = 0; i < count; ++i) {
    moved[i] = at_.trial[at_.active[i]].normal_compliance * right[first_[i]];
  }
  Eigen::VectorXd normal = pressed_by(moved);
  if (force_given()) {
    const double indentation = (right[size_ - 1] - normal.sum()) / by_one_.sum();
    normal += indentation * by_one_;
    result[size_ - 1] = indentation;
  }
  CellVector values(3 * problem_.area.size(), 0.0); // tangential displacements, then forces
  for (int i = 0; i < count; ++i) {
    const int cell = at_.active[i];
    result[first_[i]] = normal[i];
    for (int c = 0; c < 2 && !follows(cell); ++c) {
      const double given =
          right[first_[i] + 1 + c] + at_.response[cell].tangential.by_normal[c] * normal[i];
      result[first_[i] + 1 + c] = given;
      values[3 * static_cast<std::size_t>(cell) + 1 + static_cast<std::size_t>(c)] =
          at_.trial[cell].tangential_compliance * given;
    }
  }
  if (!sticks_) {
    return result;
  }
  problem_.product->invert_tangential(values);
  for (int i = 0; i < count; ++i) {
    const int cell = at_.active[i];
    if (follows(cell)) {
      continue;
    }
    const auto& by_trial = at_.response[cell].tangential.by_trial;
    const double* held = values.data() + 3 * static_cast<std::ptrdiff_t>(cell) + 1;
    const std::array<double, 2> more{held[0] - result[first_[i] + 1],
                                     held[1] - result[first_[i] + 2]};
    for (int r = 0; r < 2; ++r) {
      result[first_[i] + 1 + r] += by_trial[r][0] * more[0] + by_trial[r][1] * more[1];
    }
  }
  return result;
}

CellVector ContactLinearisation::settle_followers(CellVector& force) const {
  const CellVector before = force;
  for (int cell = 0; cell < problem_.cells(); ++cell) {
    double* own = force.data() + 3 * static_cast<std::ptrdiff_t>(cell);
    const CellResponse& response = at_.response[cell];
    if (response.status == CellStatus::separated) {
      own[0] = own[1] = own[2] = 0;
    } else if (follows(cell)) {
      for (std::size_t c = 0; c < 2; ++c) {
        own[1 + c] = response.tangential.traction[c] +
                     response.tangential.by_normal[c] * (own[0] - response.normal);
      }
    }
  }
  return force == before ? at_.surface : problem_.surface_displacement(force);
}

Eigen::VectorXd ContactLinearisation::residual(const Iterate& iterate,
                                               const CellVector& surface) const {
  Eigen::VectorXd result(size_);
  for (std::size_t i = 0; i < at_.active.size(); ++i) {
    const int cell = at_.active[i];
    const double* own = iterate.force.data() + 3 * static_cast<std::ptrdiff_t>(cell);
    const CellTrial now =
        problem_.cell_trial(cell, step_, iterate.indentation, iterate.force, surface);
    const CellResponse& response = at_.response[cell];
    result[first_[i]] =
        response.status == CellStatus::pulled
            ? own[0] + now.pull -
                  now.pull_slope * problem_.opening(cell, iterate.indentation, surface)
            : own[0] - now.normal;
    for (int r = 0; r < 2 && !follows(cell); ++r) {
      double allowed = response.tangential.traction[r] +
                       response.tangential.by_normal[r] * (own[0] - response.normal);
      for (int s = 0; s < 2; ++s) {
        allowed += response.tangential.by_trial[r][s] *
                   (now.tangential[s] - at_.trial[cell].tangential[s]);
      }
      result[first_[i] + 1 + r] = own[1 + r] - allowed;
    }
  }
  if (force_given()) {
    result[size_ - 1] = total_normal_force(iterate.force) - step_.load.value;
  }
  return result;
}

void ContactLinearisation::correct(const Eigen::PartialPivLU<Eigen::MatrixXd>& factor,
                                   Iterate& iterate) const {
  const CellVector surface = settle_followers(iterate.force);
  move(factor.solve(residual(iterate, surface)), iterate);
}

void ContactLinearisation::correct_by_products(double reduction, Iterate& iterate) {
  if (force_given()) {
    by_one_ = pressed_by(Eigen::VectorXd::Ones(static_cast<Eigen::Index>(at_.active.size())));
  }
  const CellVector surface = settle_followers(iterate.force);
  move(gmres([&](const Eigen::VectorXd& change) { return times(change); },
             [&](const Eigen::VectorXd& right) { return about_inverse(right); },
             residual(iterate, surface), reduction),
       iterate);
}

/// Subtracts changes of the unknowns from an iterate.
void ContactLinearisation::move(const Eigen::VectorXd& change, Iterate& iterate) const {
  for (std::size_t i = 0; i < at_.active.size(); ++i) {
    const int cell = at_.active[i];
    double* own = iterate.force.data() + 3 * static_cast<std::ptrdiff_t>(cell);
    own[0] -= change[first_[i]];
    for (int c = 0; c < 2; ++c) {
      own[1 + c] -= follows(cell) ? at_.response[cell].tangential.by_normal[c] * change[first_[i]]
                                  : change[first_[i] + 1 + c];
    }
  }
  if (force_given()) {
    iterate.indentation -= change[size_ - 1];
  }
}

} // namespace ionskin::mechanics
