// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/surface/gmres.hpp"

#include "ionskin/base/system/interrupt.hpp"

#include <Eigen/Jacobi>

#include <vector>

namespace ionskin::mechanics {
namespace {

constexpr Eigen::Index most_directions = 60; ///< number of directions before a restart
constexpr int most_begun = 5;                ///< largest number of starts
/// Ratio of the residuals at successive starts above which the iteration ends [1].
constexpr double least_progress = 0.9;

/// Orthonormal directions of a Krylov space, and the least residual in that space by Givens
/// rotations.
class KrylovSpace {
public:
  explicit KrylovSpace(const Eigen::VectorXd& residual)
      : rest_(Eigen::VectorXd::Zero(most_directions + 1)),
        triangle_(Eigen::MatrixXd::Zero(most_directions, most_directions)) {
    rest_(0) = residual.norm();
    directions_.emplace_back(residual / rest_(0));
  }

  const Eigen::VectorXd& last() const { return directions_.back(); }
  Eigen::Index size() const { return static_cast<Eigen::Index>(rotations_.size()); }
  double residual() const { return std::abs(rest_(size())); }
  /// True if no direction can be added.
  bool full() const { return size() == most_directions || ended_; }

  /// Adds a direction.
  /// @param next product of the equations with the last direction
  void add(Eigen::VectorXd next) {
    const Eigen::Index n = size();
    Eigen::VectorXd column(n + 2);
    for (Eigen::Index i = 0; i <= n; ++i) {
      const Eigen::VectorXd& direction = directions_[static_cast<std::size_t>(i)];
      column(i) = direction.dot(next);
      next -= column(i) * direction;
    }
    column(n + 1) = next.norm();
    ended_ = !(column(n + 1) > 0);
    if (!ended_) {
      directions_.emplace_back(next / column(n + 1));
    }
    for (Eigen::Index i = 0; i < n; ++i) {
      column.applyOnTheLeft(i, i + 1, rotations_[static_cast<std::size_t>(i)].adjoint());
    }
    Eigen::JacobiRotation<double> rotation;
    rotation.makeGivens(column(n), column(n + 1));
    column.applyOnTheLeft(n, n + 1, rotation.adjoint());
    rest_.applyOnTheLeft(n, n + 1, rotation.adjoint());
    rotations_.push_back(rotation);
    triangle_.col(n).head(n + 1) = column.head(n + 1);
  }

  /// Combination of the directions that has the least residual.
  Eigen::VectorXd combination() const {
    const Eigen::VectorXd factors = triangle_.topLeftCorner(size(), size())
                                        .triangularView<Eigen::Upper>()
                                        .solve(rest_.head(size()));
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(directions_.front().size());
    for (Eigen::Index i = 0; i < size(); ++i) {
      sum += factors(i) * directions_[static_cast<std::size_t>(i)];
    }
    return sum;
  }

private:
  std::vector<Eigen::VectorXd> directions_;
  std::vector<Eigen::JacobiRotation<double>> rotations_;
  Eigen::VectorXd rest_;
  Eigen::MatrixXd triangle_;
  bool ended_ = false;
};

} // namespace

Eigen::VectorXd gmres(const LinearMap& product, const LinearMap& about_inverse,
                      const Eigen::VectorXd& right, double reduction) {
  Eigen::VectorXd solution = Eigen::VectorXd::Zero(right.size()), residual = right;
  const double wanted = reduction * right.norm();
  for (int begun = 0; begun < most_begun && residual.norm() > wanted; ++begun) {
    const double before = residual.norm();
    KrylovSpace space(residual);
    while (space.residual() > wanted && !space.full()) {
      base::check_interrupt();
      space.add(product(about_inverse(space.last())));
    }
    const bool found = space.residual() <= wanted;
    solution += about_inverse(space.combination());
    if (found) {
      break; // Newton's method checks the true residual
    }
    residual = right - product(solution);
    if (!(residual.norm() < least_progress * before)) {
      break;
    }
  }
  return solution;
}

} // namespace ionskin::mechanics
