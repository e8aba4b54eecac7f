// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/parallel/worker_team.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace ionskin::parallel {

/// Reductions and updates of long vectors on several threads. Sums are formed per segment and added
/// in a fixed order: the result is the same bit for bit on any number of threads.
class VectorOperations {
public:
  explicit VectorOperations(WorkerTeam& team) : team_(team) {}

  double dot(std::span<const double> a, std::span<const double> b);
  double norm(std::span<const double> a);
  double largest_magnitude(std::span<const double> a);
  /// y += factor x
  void add(double factor, std::span<const double> x, std::span<double> y) const;
  /// y = x + factor d
  void combine(std::span<const double> x, double factor, std::span<const double> d,
               std::span<double> y) const;
  /// Makes `vector` orthogonal to the first `count` orthonormal `basis` vectors (classical
  /// Gram-Schmidt, two sweeps over memory).
  /// @param coefficients receives the products with the basis vectors
  /// @returns the norm of the remainder
  double orthogonalise(const std::vector<std::vector<double>>& basis, std::size_t count,
                       std::span<double> vector, std::span<double> coefficients);
  /// y = factor x
  void scale(double factor, std::span<const double> x, std::span<double> y) const;

private:
  /// Calls `body(segment, begin, end)` on segments of fixed length.
  template <class Body> void for_segments(std::size_t length, const Body& body) const;
  double sum_partial(std::size_t parts) const;

  WorkerTeam& team_;
  std::vector<double> partial_;
};

} // namespace ionskin::parallel
