// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/parallel/vector_operations.hpp"

#include <functional>
#include <span>
#include <vector>

namespace ionskin::electrochemistry {

/// Restarted GMRES (Saad and Schultz 1986, doi 10.1137/0907058) with zero initial guess. Written
/// here because Eigen's needs a matrix type, allocates in every call and sums in an order of its
/// own; this one keeps its basis, and its sums do not depend on the number of threads.
class Gmres {
public:
  using Operator = std::function<void(std::span<const double> x, std::span<double> y)>;

  struct Result {
    int iterations = 0;
    double relative_residual = 1; ///< 2-norm, against that of the right-hand side
  };

  Gmres(std::size_t unknowns, parallel::WorkerTeam& team);

  /// Solves A x = b until the residual has fallen by `tolerance` or `iteration_limit` is reached.
  Result solve(const Operator& apply, std::span<const double> b, std::span<double> x,
               double tolerance, int iteration_limit);

private:
  static constexpr int basis_limit = 20;

  double cycle(const Operator& apply, double residual_norm, double goal, int iteration_limit,
               std::span<double> x, int& iterations);
  std::span<double> basis_vector(int index);

  parallel::VectorOperations vectors_;
  std::size_t unknowns_;
  std::vector<std::vector<double>> basis_; ///< grows to what is needed and is kept
};

} // namespace ionskin::electrochemistry
