// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/parallel/vector_operations.hpp"

#include <functional>
#include <span>
#include <vector>

namespace ionskin::electrochemistry {

/// Restarted GMRES solver (Saad and Schultz 1986, doi 10.1137/0907058) with zero initial guess. It
/// is written here because Eigen's needs a matrix type, allocates in every call and sums in an
/// order of its own; this one reuses its basis, and its sums do not depend on the number of
/// threads.
class Gmres {
public:
  /// Function that computes y = A x.
  using Operator = std::function<void(std::span<const double> x, std::span<double> y)>;

  /// Outcome of a solution.
  struct Result {
    int iterations = 0;
    double relative_residual = 1; ///< 2-norm of the residual over that of b
  };

  Gmres(std::size_t unknowns, parallel::WorkerTeam& team);

  /// Solves A x = b from x = 0 until the residual is `tolerance` times that of b or
  /// `iteration_limit` iterations are done.
  /// @param apply computes y = A x
  /// @param x receives the solution
  Result solve(const Operator& apply, std::span<const double> b, std::span<double> x,
               double tolerance, int iteration_limit);

private:
  static constexpr int basis_limit = 20;

  double cycle(const Operator& apply, double residual_norm, double goal, int iteration_limit,
               std::span<double> x, int& iterations);
  std::span<double> basis_vector(int index);

  parallel::VectorOperations vectors_;
  std::size_t unknowns_;
  std::vector<std::vector<double>> basis_; ///< grows to the length needed, and is reused
};

} // namespace ionskin::electrochemistry
