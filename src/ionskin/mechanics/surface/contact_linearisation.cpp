// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/surface/contact_linearisation.hpp"

#include "ionskin/base/largest.hpp"

#include <algorithm>
#include <cmath>

namespace ionskin::mechanics {

using laws::CellResponse;
using laws::CellStatus;
using laws::CellTrial;

Standing::Standing(const ContactProblem& problem, const SliderStep& step, const Iterate& iterate) {
  const CellVector surface = problem.surface_displacement(iterate.force);
  if (step.load.kind == LoadKind::force) {
    residual = std::abs(total_normal_force(iterate.force) - step.load.value);
  }
  for (int cell = 0; cell < problem.cells(); ++cell) {
    const double* force = iterate.force.data() + 3 * static_cast<std::ptrdiff_t>(cell);
    trial.push_back(problem.cell_trial(cell, step, iterate.indentation, iterate.force, surface));
    response.push_back(laws::cell_response(problem.friction, trial.back()));
    const CellResponse& now = response.back();
    status.push_back(now.status);
    residual = base::larger(residual, std::abs(force[0] - now.normal));
    for (std::size_t c = 0; c < 2; ++c) {
      residual = base::larger(residual, std::abs(force[1 + c] - now.tangential.traction[c]));
    }
    largest_force = std::max(largest_force, std::abs(force[0]));
    if (now.status != CellStatus::separated) {
      active.push_back(cell);
    }
  }
}

ContactLinearisation::ContactLinearisation(const ContactProblem& problem, const SliderStep& step,
                                           const Standing& at)
    : problem_(problem), step_(step), at_(at) {
  for (const int cell : at_.active) {
    first_.push_back(size_);
    size_ += follows(cell) ? 1 : 3;
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

Eigen::MatrixXd ContactLinearisation::matrix() const {
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(size_, size_);
  const int count = static_cast<int>(at_.active.size());
  Eigen::VectorXd surface; // by an unknown
  for (int j = 0; j < count; ++j) {
    for (int s = 0; s < (follows(at_.active[j]) ? 1 : 3); ++s) {
      displacement_by(j, s, surface);
      double* column = matrix.col(first_[j] + s).data();
      for (int i = 0; i < count; ++i) {
        const int cell = at_.active[i];
        const double* moved = surface.data() + 3 * static_cast<std::ptrdiff_t>(cell);
        const CellTrial& trial = at_.trial[cell];
        const laws::FrictionResponse& friction = at_.response[cell].tangential;
        double* row = column + first_[i];
        const bool pulled = at_.status[cell] == CellStatus::pulled;
        row[0] = pulled ? -trial.pull_slope * moved[0] : moved[0] / trial.normal_compliance;
        if (!follows(cell)) {
          const double x = moved[1] / trial.tangential_compliance,
                       y = moved[2] / trial.tangential_compliance;
          row[1] = friction.by_trial[0][0] * x + friction.by_trial[0][1] * y;
          row[2] = friction.by_trial[1][0] * x + friction.by_trial[1][1] * y;
        }
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
        // Where the skin itself is held along s, its force does not change the trial force.
        const int own = 3 * cell + 1 + s;
        const bool held = problem_.compliance(own, own) <= 0;
        matrix(first + 1 + r, first + 1 + s) +=
            (r == s ? 1.0 : 0.0) - (held ? 0.0 : response.tangential.by_trial[r][s]);
      }
    }
    if (force_given()) {
      const CellTrial& trial = at_.trial[cell];
      matrix(first, size_ - 1) =
          response.status == CellStatus::pulled ? trial.pull_slope : -1 / trial.normal_compliance;
      matrix(size_ - 1, first) = 1;
    }
  }
  return matrix;
}

CellVector ContactLinearisation::settle_followers(CellVector& force) const {
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
  return problem_.surface_displacement(force);
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
  const Eigen::VectorXd change = factor.solve(residual(iterate, surface));
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
