// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/mechanics/surface/contact_linearisation.hpp"

#include <Eigen/LU>

#include <array>
#include <vector>

namespace ionskin::mechanics {

/// Semi-smooth Newton for steps that follow each other closely: the equations are those of
/// `contact_newton`, but the factorisation is kept from step to step for as long as the same cells
/// touch, stick and slip and the residual falls fast enough; some sweeps of Gauss-Seidel go before
/// a change of that pattern.
class KeptNewton {
public:
  /// @param iterate start on entry, such as the state before; the solution on return when converged
  /// @returns whether it converged, to 1e-10 of the largest normal force, and with adhesion to an
  /// equilibrium that can last
  bool solve(const ContactProblem& problem, const SliderStep& step, Iterate& iterate);

  int iterations() const { return iterations_; } ///< of the last solve
  int factorisations() const { return factorisations_; }
  /// Forgets pattern and factorisation, as after a solution by other means.
  void forget() {
    factor_size_ = 0;
    settled_by_ = {};
  }
  /// By what the last solution moved the sums of the tangential forces in the end, within the
  /// tolerance, so that slipping cells carry their limits [N].
  const std::array<double, 2>& settled_by() const { return settled_by_; }

private:
  /// Where the cells stand at an iterate.
  struct Standing {
    std::vector<CellPredictor> predictors;
    std::vector<CellStatus> status;
    std::vector<int> touching;
    double residual = 0, scale = 0; ///< [N]
  };
  static Standing standing(const ContactProblem& problem, const SliderStep& step,
                           const Iterate& iterate);
  void factorise(const ContactProblem& problem, const SliderStep& step, const Iterate& iterate,
                 const Standing& at);
  bool is_stable(const ContactProblem& problem, const SliderStep& step, const Iterate& iterate,
                 const Standing& at);
  void correct(const ContactProblem& problem, const SliderStep& step, const Standing& at,
               Iterate& iterate) const;
  static void settle(const ContactProblem& problem, const SliderStep& step, const Standing& at,
                     Iterate& iterate);

  Eigen::PartialPivLU<Eigen::MatrixXd> factor_;
  Eigen::Index factor_size_ = 0;       ///< 0: none
  std::vector<CellStatus> factorised_; ///< the pattern it belongs to
  int iterations_ = 0, factorisations_ = 0;
  std::array<double, 2> settled_by_{};
};

} // namespace ionskin::mechanics
