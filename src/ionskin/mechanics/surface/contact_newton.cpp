// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/surface/contact_newton.hpp"

#include "ionskin/mechanics/output/contact_solution.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace ionskin::mechanics {
namespace {

/// Residual of a solution, over the largest normal force of a cell [1].
constexpr double newton_tolerance = contact_tolerance / 10;
constexpr int most_iterations = 30; ///< largest number of iterations, unless a limit below applies
/// Limits of a solution with `Patience::much`: its iterations, the first iteration in which a step
/// is halved if the residual grows, and the number of such halvings.
constexpr int most_patient_iterations = 100, first_halved = 15, most_halvings = 4;
/// Limits of a solution by products: its iterations, and the reduction of the residual of the
/// linear equations. With a weaker reduction, cells alternate between stick and slip.
constexpr int most_iterations_by_products = 100;
constexpr double reduction_by_products = 1e-3;
/// Ratio of successive residuals above which the Jacobian is factorised anew.
constexpr double least_contraction = 0.2;

/// True if the determinant of a factorised Jacobian is positive. In an adhesive contact this means
/// that the equilibrium is stable: the sign changes where the pull falls with the opening faster
/// than the skin springs back, docs/model.md (43).
bool has_positive_determinant(const Eigen::PartialPivLU<Eigen::MatrixXd>& factor) {
  bool positive = factor.permutationP().determinant() > 0;
  for (const double pivot : factor.matrixLU().diagonal()) {
    positive = positive == (pivot > 0);
  }
  return positive;
}

/// Restarts from an undeformed skin when no cell is in contact any more, so that the skin rises to
/// the slider. A given force is put on the cell that the slider meets first.
void begin_anew(const ContactProblem& problem, const SliderStep& step, Iterate& iterate) {
  std::ranges::fill(iterate.force, 0.0);
  if (step.load.kind == LoadKind::force) {
    int first = 0;
    for (int cell = 1; cell < problem.cells(); ++cell) {
      first = problem.free_gap(cell) < problem.free_gap(first) ? cell : first;
    }
    iterate.force[3 * static_cast<std::size_t>(first)] = step.load.value;
    iterate.indentation =
        problem.free_gap(first) + problem.own_compliance(first, 0) * step.load.value;
  }
}

/// Sets cells to stick that an iteration moved so far that they would slip against their traction.
/// Otherwise they would alternate between stick and slip.
void hold_turned(const ContactProblem& problem, const SliderStep& step, const Iterate& iterate,
                 ContactEvaluation& at) {
  for (const int cell : at.active) {
    const double* force = iterate.force.data() + 3 * static_cast<std::ptrdiff_t>(cell);
    const laws::TangentialVector& trial = at.trial[cell].tangential;
    if (at.status[cell] == laws::CellStatus::slipping &&
        force[1] * trial[0] + force[2] * trial[1] < 0 &&
        problem.friction_limit(cell, at.response[cell].normal, 0, step.time_step) > 0) {
      at.status[cell] = at.response[cell].status = laws::CellStatus::sticking;
      at.response[cell].tangential = {true, trial, {{{1, 0}, {0, 1}}}, {}};
    }
  }
}

/// Replaces an iterate by the mean of it and the iterate before.
void go_half_back(const Iterate& before, Iterate& now) {
  for (std::size_t i = 0; i < now.force.size(); ++i) {
    now.force[i] = (now.force[i] + before.force[i]) / 2;
  }
  now.indentation = (now.indentation + before.indentation) / 2;
}

} // namespace

void ContactNewton::factorise(const ContactLinearisation& equations, const ContactEvaluation& at) {
  factor_.compute(equations.matrix());
  factor_size_ = equations.size();
  factorised_ = at.status;
  ++factorisations_;
}

/// Adjusts forces, within the tolerance, to the status of their cells: open cells carry nothing,
/// slipping cells their friction limit, and no cell is pulled by more than its adhesion.
void ContactNewton::settle(const ContactProblem& problem, const ContactEvaluation& at,
                           Iterate& iterate) {
  settled_by_ = {};
  for (int cell = 0; cell < problem.cells(); ++cell) {
    double* force = iterate.force.data() + 3 * static_cast<std::ptrdiff_t>(cell);
    const std::array<double, 2> found{force[1], force[2]};
    const laws::CellTrial& trial = at.trial[cell];
    force[0] =
        at.status[cell] == laws::CellStatus::separated ? 0.0 : std::max(-trial.pull, force[0]);
    if (at.status[cell] == laws::CellStatus::slipping) {
      const auto friction = laws::cell_friction(problem.friction, trial, force[0], true);
      force[1] = friction.traction[0];
      force[2] = friction.traction[1];
    } else if (at.status[cell] != laws::CellStatus::sticking) {
      force[1] = force[2] = 0;
    }
    settled_by_[0] += force[1] - found[0];
    settled_by_[1] += force[2] - found[1];
  }
}

bool ContactNewton::solve(const ContactProblem& problem, const SliderStep& step, Iterate& iterate,
                          Patience patience) {
  if (step.load.kind == LoadKind::indentation) {
    iterate.indentation = step.load.value;
  }
  Iterate now = iterate, before = iterate;
  double last = std::numeric_limits<double>::infinity(), reached = last;
  int halvings = 0;
  const bool patient = patience == Patience::much && !problem.product;
  const int most = problem.product ? most_iterations_by_products
                   : patient       ? most_patient_iterations
                                   : most_iterations;
  for (int i = 0; i < most; ++i) {
    iterations_ = i;
    ContactEvaluation at(problem, step, now);
    if (!std::isfinite(at.residual)) {
      return false;
    }
    if (!step.sliding_direction && i > 0 && at.residual > newton_tolerance * at.largest_force) {
      hold_turned(problem, step, now, at);
    }
    ContactLinearisation equations(problem, step, at);
    if (at.residual <= newton_tolerance * at.largest_force) {
      if (problem.friction.adhesion.pulls() && problem.pull.empty() && !at.active.empty()) {
        factorise(equations, at);
        if (!has_positive_determinant(factor_)) {
          return false;
        }
      }
      settle(problem, at, now);
      iterate = std::move(now);
      return true;
    }
    if (at.active.empty()) {
      begin_anew(problem, step, now);
      last = reached = std::numeric_limits<double>::infinity();
      continue;
    }
    if (patient && i >= first_halved && at.residual > reached && halvings < most_halvings) {
      ++halvings;
      go_half_back(before, now);
      continue;
    }
    if (patient) {
      halvings = 0;
      reached = at.residual;
      before = now;
    }
    if (problem.product) {
      equations.correct_by_products(reduction_by_products, now);
      continue;
    }
    const bool known = factor_size_ == equations.size() && factorised_ == at.status;
    if (!known || at.residual > least_contraction * last) {
      factorise(equations, at);
    }
    last = at.residual;
    equations.correct(factor_, now);
  }
  return false;
}

} // namespace ionskin::mechanics
