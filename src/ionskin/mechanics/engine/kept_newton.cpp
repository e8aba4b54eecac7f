// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/engine/kept_newton.hpp"

#include "ionskin/base/largest.hpp"
#include "ionskin/mechanics/output/contact_solution.hpp"
#include "ionskin/mechanics/surface/projected_gauss_seidel.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace ionskin::mechanics {
namespace {

constexpr double kept_tolerance = contact_tolerance / 10;
constexpr int most_iterations = 30;
/// A residual that falls more slowly has outgrown the factorisation.
constexpr double least_contraction = 0.2;
/// Gauss-Seidel goes before a change of pattern as long as the residual is large.
constexpr double rough_residual = 1e-4;
constexpr int sweeps_between = 10;
constexpr int most_rounds = 6;

} // namespace

KeptNewton::Standing KeptNewton::standing(const ContactProblem& problem, const SliderStep& step,
                                          const Iterate& iterate) {
  const CellVector surface = problem.surface_displacement(iterate.force);
  Standing at;
  if (step.load.kind == LoadKind::force) {
    at.residual = std::abs(total_normal_force(iterate.force) - step.load.value);
  }
  for (int cell = 0; cell < problem.cells(); ++cell) {
    at.predictors.push_back(predict(problem, step, iterate, surface, cell));
    const CellPredictor& now = at.predictors.back();
    at.status.push_back(now.status);
    at.residual = base::larger(at.residual, now.residual);
    at.scale = std::max(at.scale, std::abs(iterate.force[3 * static_cast<std::size_t>(cell)]));
    if (now.status != CellStatus::separated) {
      at.touching.push_back(cell);
    }
  }
  return at;
}

void KeptNewton::factorise(const ContactProblem& problem, const SliderStep& step,
                           const Iterate& iterate, const Standing& at) {
  LinearSystem system(problem, step, at.touching);
  system.add_rows(at.predictors, iterate);
  factor_.compute(system.matrix());
  factor_size_ = system.matrix().rows();
  factorised_ = at.status;
  ++factorisations_;
}

void KeptNewton::correct(const ContactProblem& problem, const SliderStep& step, const Standing& at,
                         Iterate& iterate) const {
  for (int cell = 0; cell < problem.cells(); ++cell) {
    if (at.status[cell] == CellStatus::separated) {
      std::fill_n(iterate.force.begin() + 3 * static_cast<std::ptrdiff_t>(cell), 3, 0.0);
    }
  }
  const CellVector surface = problem.surface_displacement(iterate.force);
  Eigen::VectorXd residual(factor_size_);
  for (std::size_t i = 0; i < at.touching.size(); ++i) {
    const int cell = at.touching[i];
    const std::size_t from = 3 * static_cast<std::size_t>(cell);
    const auto row = static_cast<Eigen::Index>(3 * i);
    const std::array<double, 2> tangential{iterate.force[from + 1], iterate.force[from + 2]};
    const double opening = problem.opening(cell, iterate.indentation, surface);
    if (at.status[cell] == CellStatus::pulled) {
      residual[row] =
          iterate.force[from] + problem.largest_pull(cell) - problem.pull_slope(cell) * opening;
      residual[row + 1] = tangential[0];
      residual[row + 2] = tangential[1];
      continue;
    }
    residual[row] = opening / problem.own_compliance(cell, 0);
    const auto slip = slip_increment(step, surface, cell);
    const double compliance = problem.own_compliance(cell, 1);
    std::array<double, 2> rest{};
    if (at.status[cell] == CellStatus::sticking) {
      for (std::size_t c = 0; c < 2; ++c) {
        const int own = static_cast<int>(from + c) + 1;
        rest[c] = problem.compliance(own, own) > 0 ? -slip[c] / compliance : tangential[c];
      }
    } else {
      const std::array<double, 2> trial{tangential[0] + slip[0] / compliance,
                                        tangential[1] + slip[1] / compliance};
      const auto friction = problem.friction_response(cell, std::max(0.0, iterate.force[from]),
                                                      trial, compliance, step, true);
      for (std::size_t c = 0; c < 2; ++c) {
        rest[c] = tangential[c] - friction.traction[c];
      }
    }
    residual[row + 1] = rest[0];
    residual[row + 2] = rest[1];
  }
  const bool force_given = step.load.kind == LoadKind::force;
  if (force_given) {
    residual[factor_size_ - 1] = total_normal_force(iterate.force) - step.load.value;
  }
  const Eigen::VectorXd change = factor_.solve(residual);
  for (std::size_t i = 0; i < at.touching.size(); ++i) {
    for (std::size_t c = 0; c < 3; ++c) {
      iterate.force[3 * static_cast<std::size_t>(at.touching[i]) + c] -=
          change[static_cast<Eigen::Index>(3 * i + c)];
    }
  }
  if (force_given) {
    iterate.indentation -= change[factor_size_ - 1];
  }
}

/// Moves forces within the tolerance to where their cells stand: open ones carry nothing, slipping
/// ones their limit, and none is pulled by more than its adhesion.
void KeptNewton::settle(const ContactProblem& problem, const SliderStep& step, const Standing& at,
                        Iterate& iterate) {
  for (int cell = 0; cell < problem.cells(); ++cell) {
    double* force = iterate.force.data() + 3 * static_cast<std::ptrdiff_t>(cell);
    const CellPredictor& predictor = at.predictors[cell];
    force[0] = at.status[cell] == CellStatus::separated
                   ? 0.0
                   : std::max(-problem.largest_pull(cell), force[0]);
    if (at.status[cell] == CellStatus::separated || at.status[cell] == CellStatus::pulled) {
      force[1] = force[2] = 0;
    } else if (at.status[cell] == CellStatus::slipping) {
      const auto friction = problem.friction_response(cell, force[0], predictor.tangential,
                                                      problem.own_compliance(cell, 1), step, true);
      force[1] = friction.traction[0];
      force[2] = friction.traction[1];
    }
  }
}

bool KeptNewton::is_stable(const ContactProblem& problem, const SliderStep& step,
                           const Iterate& iterate, const Standing& at) {
  if (at.touching.empty()) {
    return true;
  }
  factorise(problem, step, iterate, at);
  return has_positive_determinant(factor_);
}

bool KeptNewton::solve(const ContactProblem& problem, const SliderStep& step, Iterate& iterate) {
  const bool force_given = step.load.kind == LoadKind::force;
  if (!force_given) {
    iterate.indentation = step.load.value;
  }
  Iterate now = iterate;
  double last = std::numeric_limits<double>::infinity();
  for (int rounds = 0, i = 0; i < most_iterations; ++i) {
    iterations_ = i;
    const Standing at = standing(problem, step, now);
    if (!std::isfinite(at.residual)) {
      return false;
    }
    if (at.residual <= kept_tolerance * at.scale) {
      if (problem.friction.adhesion.pulls() && !is_stable(problem, step, now, at)) {
        return false;
      }
      const CellVector found = now.force;
      settle(problem, step, at, now);
      settled_by_ = {};
      for (std::size_t at_cell = 0; at_cell < found.size(); at_cell += 3) {
        settled_by_[0] += now.force[at_cell + 1] - found[at_cell + 1];
        settled_by_[1] += now.force[at_cell + 2] - found[at_cell + 2];
      }
      iterate = std::move(now);
      return true;
    }
    // A slider lifted by more than cells give alone: the skin that they press down rises too.
    const bool lost = at.touching.empty();
    if (lost && (force_given || rounds == most_rounds)) {
      return false;
    }
    const auto size = static_cast<Eigen::Index>(3 * at.touching.size() + (force_given ? 1 : 0));
    const bool known = factor_size_ == size && factorised_ == at.status;
    if (lost || (!known && i > 0 && !force_given && rounds < most_rounds &&
                 at.residual > rough_residual * at.scale)) {
      ++rounds;
      projected_gauss_seidel(problem, step, now.indentation, now.force, rough_residual,
                             sweeps_between);
      last = std::numeric_limits<double>::infinity();
      continue;
    }
    if (!known || at.residual > least_contraction * last) {
      factorise(problem, step, now, at);
    }
    last = at.residual;
    correct(problem, step, at, now);
  }
  return false;
}

} // namespace ionskin::mechanics
