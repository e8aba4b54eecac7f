// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/mechanics/surface/contact_linearisation.hpp"

#include <Eigen/LU>

#include <array>
#include <vector>

namespace ionskin::mechanics {

/// Limit of iterations of Newton's method: as many as most solutions take, or as many as may still
/// help. Cells that barely slip on a stiff electrode over a soft core alternate between stick and
/// slip from one iteration to the next.
enum class Patience { usual, much };

/// Semi-smooth Newton method on the projection form of contact and friction (Alart and Curnier
/// 1991, doi 10.1016/0045-7825(91)90022-X), with the cells that touch as active set. Under a given
/// force the indentation is a further unknown, and the sum of the normal forces a further equation.
/// The factorised Jacobian is reused, also in the next solution, as long as the same cells touch,
/// stick and slip and the residual falls fast enough.
class ContactNewton {
public:
  /// Solves for the equilibrium at the end of a step.
  /// @param iterate on entry the start, such as the state before; on return the solution if it
  ///   converged
  /// @returns true if the residual fell to 1e-10 of the largest normal force and, with adhesion,
  ///   the equilibrium is stable
  bool solve(const ContactProblem& problem, const SliderStep& step, Iterate& iterate,
             Patience patience = Patience::usual);

  int iterations() const { return iterations_; }         ///< of the last solution
  int factorisations() const { return factorisations_; } ///< in all solutions
  /// Discards the factorised Jacobian, as after a solution by other means.
  void forget() {
    factor_size_ = 0;
    settled_by_ = {};
  }
  /// Change of the sums of the tangential forces along x and y that the last solution made at its
  /// end, within the tolerance, to put slipping cells exactly at their friction limit [N].
  const std::array<double, 2>& settled_by() const { return settled_by_; }

private:
  void factorise(const ContactLinearisation& equations, const ContactEvaluation& at);
  void settle(const ContactProblem& problem, const ContactEvaluation& at, Iterate& iterate);

  Eigen::PartialPivLU<Eigen::MatrixXd> factor_;
  Eigen::Index factor_size_ = 0;             ///< size of the factorised Jacobian; 0: none
  std::vector<laws::CellStatus> factorised_; ///< status of the cells for which it was made
  int iterations_ = 0, factorisations_ = 0;
  std::array<double, 2> settled_by_{};
};

} // namespace ionskin::mechanics
