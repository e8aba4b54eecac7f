// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/surface/contact_newton.hpp"

#include "ionskin/base/largest.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace ionskin::mechanics {
namespace {

enum class CellStatus { separated, sticking, slipping };

/// Where one cell stands: the forces that contact and friction would allow in its present motion.
struct CellPredictor {
  CellStatus status = CellStatus::separated;
  std::array<double, 2> tangential{}; ///< trial force t + slip / compliance [N]
  double slip = 0;                    ///< length of the slip increment [m]
  double residual = 0;                ///< of the projection equations [N]
};

/// Where the iteration stands.
struct Iterate {
  CellVector force;
  double indentation = 0;
};

CellPredictor predict(const ContactProblem& problem, const SliderStep& step, const Iterate& iterate,
                      const CellVector& surface, int cell) {
  const std::size_t at = 3 * static_cast<std::size_t>(cell);
  const CellVector& force = iterate.force;
  CellPredictor result;
  const double normal = force[at] + (iterate.indentation - problem.gap[cell] - surface[at]) /
                                        problem.own_compliance(cell, 0);
  result.residual = std::abs(force[at] - base::larger(0.0, normal));
  if (normal <= 0) {
    result.residual = base::larger(result.residual,
                                   base::larger(std::abs(force[at + 1]), std::abs(force[at + 2])));
    return result;
  }
  const auto slip = slip_increment(step, surface, cell);
  const double compliance = problem.own_compliance(cell, 1);
  result.slip = std::hypot(slip[0], slip[1]);
  result.tangential = {force[at + 1] + slip[0] / compliance, force[at + 2] + slip[1] / compliance};
  const double limit = problem.friction_limit(cell, normal, result.slip, step.time_step);
  const bool sticks = limit > 0 && std::hypot(result.tangential[0], result.tangential[1]) <= limit;
  result.status = sticks ? CellStatus::sticking : CellStatus::slipping;
  const auto allowed = laws::project_on_disc(result.tangential, limit);
  result.residual =
      base::larger(result.residual, base::larger(std::abs(force[at + 1] - allowed[0]),
                                                 std::abs(force[at + 2] - allowed[1])));
  return result;
}

/// The linearised equations of the touching cells; unknowns are their forces and, under a given
/// force, the indentation at the end.
class LinearSystem {
public:
  LinearSystem(const ContactProblem& problem, const SliderStep& step,
               const std::vector<int>& touching)
      : problem_(problem), step_(step), touching_(touching),
        matrix_(Eigen::MatrixXd::Zero(size(), size())), right_(Eigen::VectorXd::Zero(size())) {}

  void add_normal_rows() {
    for (int i = 0; i < count(); ++i) {
      const double scale = 1 / problem_.own_compliance(touching_[i], 0);
      add_displacement(3 * i, 3 * touching_[i], scale);
      right_[3 * i] = -scale * problem_.gap[touching_[i]];
      if (force_given()) {
        matrix_(3 * i, size() - 1) = -scale;
        matrix_(size() - 1, 3 * i) = 1;
      } else {
        right_[3 * i] += scale * step_.load.value;
      }
    }
    if (force_given()) {
      right_[size() - 1] = step_.load.value;
    }
  }

  void add_stick_rows(int i) {
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

  /// t = limit(n) e + (limit / |z|) (I - e e^T) dz with the trial force z and e = z / |z|.
  void add_slip_rows(int i, const CellPredictor& predictor, double normal_force) {
    const int cell = touching_[i];
    const double length = std::max(std::hypot(predictor.tangential[0], predictor.tangential[1]),
                                   std::numeric_limits<double>::min());
    const std::array<double, 2> e{predictor.tangential[0] / length,
                                  predictor.tangential[1] / length};
    const double limit =
        problem_.friction_limit(cell, normal_force, predictor.slip, step_.time_step);
    const double slope =
        problem_.friction_limit_slope(cell, normal_force, predictor.slip, step_.time_step);
    const double turning = std::min(1.0, limit / length);
    const double scale = 1 / problem_.own_compliance(cell, 1);
    for (int r = 0; r < 2; ++r) {
      const int row = 3 * i + 1 + r;
      matrix_(row, row) += 1;
      matrix_(row, 3 * i) -= slope * e[r];
      right_[row] += (limit - slope * normal_force) * e[r];
      for (int s = 0; s < 2; ++s) {
        const double weight = turning * ((r == s ? 1.0 : 0.0) - e[r] * e[s]);
        add_displacement(row, 3 * cell + 1 + s, weight * scale);
        matrix_(row, 3 * i + 1 + s) -= weight;
        right_[row] += weight * scale * free_displacement(cell, 1 + s);
      }
    }
  }

  void solve(Iterate& iterate) const {
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

private:
  int count() const { return static_cast<int>(touching_.size()); }
  bool force_given() const { return step_.load.kind == LoadKind::force; }
  int size() const { return 3 * count() + (force_given() ? 1 : 0); }
  /// Adds scale times the displacement of a component to a row.
  void add_displacement(int row, int component, double scale) {
    const double* column = problem_.compliance.column(component); // symmetric
    for (int j = 0; j < count(); ++j) {
      for (int c = 0; c < 3; ++c) {
        matrix_(row, 3 * j + c) += scale * column[3 * touching_[j] + c];
      }
    }
  }
  /// Displacement at which a cell does not slip.
  double free_displacement(int cell, int c) const {
    return step_.travel[c - 1] + step_.surface_before[3 * cell + c];
  }

  const ContactProblem& problem_;
  const SliderStep& step_;
  const std::vector<int>& touching_;
  Eigen::MatrixXd matrix_;
  Eigen::VectorXd right_;
};

} // namespace

NewtonResult contact_newton(const ContactProblem& problem, const SliderStep& step,
                            CellVector& force, double& indentation, double tolerance,
                            int most_iterations) {
  const bool force_given = step.load.kind == LoadKind::force;
  Iterate iterate{force, force_given ? indentation : step.load.value};
  std::vector<CellPredictor> predictors(problem.area.size());
  for (int iteration = 0; iteration <= most_iterations; ++iteration) {
    const CellVector surface = problem.surface_displacement(iterate.force);
    double residual =
        force_given ? std::abs(total_normal_force(iterate.force) - step.load.value) : 0.0;
    double scale = 0;
    bool same_status = iteration > 0;
    std::vector<int> touching;
    for (int cell = 0; cell < problem.cells(); ++cell) {
      const CellPredictor now = predict(problem, step, iterate, surface, cell);
      same_status = same_status && now.status == predictors[cell].status;
      predictors[cell] = now;
      residual = base::larger(residual, now.residual);
      scale = std::max(scale, std::abs(iterate.force[3 * static_cast<std::size_t>(cell)]));
      if (now.status != CellStatus::separated) {
        touching.push_back(cell);
      }
    }
    if (same_status && residual <= tolerance * scale) {
      force = std::move(iterate.force);
      indentation = iterate.indentation;
      return {true, iteration};
    }
    if (!std::isfinite(residual)) {
      break;
    }
    if (touching.empty()) {
      if (force_given) {
        break;
      }
      std::fill(iterate.force.begin(), iterate.force.end(), 0.0);
      continue;
    }
    LinearSystem system(problem, step, touching);
    system.add_normal_rows();
    for (std::size_t i = 0; i < touching.size(); ++i) {
      const int cell = touching[i];
      if (predictors[cell].status == CellStatus::sticking) {
        system.add_stick_rows(static_cast<int>(i));
      } else {
        system.add_slip_rows(static_cast<int>(i), predictors[cell],
                             std::max(0.0, iterate.force[3 * static_cast<std::size_t>(cell)]));
      }
    }
    system.solve(iterate);
  }
  return {false, most_iterations};
}

} // namespace ionskin::mechanics
