// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/mechanics/surface/contact_linearisation.hpp"

#include <Eigen/LU>

#include <array>
#include <vector>

namespace ionskin::mechanics {

/// Patience with which a solution is sought: as long as most take, or until nothing helps. Cells
/// that barely slip on a stiff electrode over a soft core turn from one iteration to the next.
enum class Patience { usual, much };

/// Semi-smooth Newton on the projection form of contact and friction (Alart and Curnier 1991,
/// doi 10.1016/0045-7825(91)90022-X), with the cells that touch as active set. Under a given force
/// the indentation is one more unknown and the sum of the normal forces one more equation. The
/// factorisation is kept, also from one solution to the next, for as long as the same cells touch,
/// stick and slip and the residual falls fast enough.
class ContactNewton {
public:
  /// Solves for the equilibrium behind a step.
  /// @param iterate start on entry, such as the state before; the solution on return when converged
  /// @returns whether it converged, to 1e-10 of the largest normal force, and with adhesion to an
  /// equilibrium that can last
  bool solve(const ContactProblem& problem, const SliderStep& step, Iterate& iterate,
             Patience patience = Patience::usual);

  int iterations() const { return iterations_; } ///< of the last solve
  int factorisations() const { return factorisations_; }
  /// Forgets the factorisation, as after a solution by other means.
  void forget() {
    factor_size_ = 0;
    settled_by_ = {};
  }
  /// Amount by which the last solution moved the sums of the tangential forces in the end, within
  /// the tolerance, so that slipping cells carry their limits [N].
  const std::array<double, 2>& settled_by() const { return settled_by_; }

private:
  void factorise(const ContactLinearisation& equations, const Standing& at);
  void settle(const ContactProblem& problem, const Standing& at, Iterate& iterate);

  Eigen::PartialPivLU<Eigen::MatrixXd> factor_;
  Eigen::Index factor_size_ = 0;             ///< 0: none
  std::vector<laws::CellStatus> factorised_; ///< the pattern it belongs to
  int iterations_ = 0, factorisations_ = 0;
  std::array<double, 2> settled_by_{};
};

} // namespace ionskin::mechanics
