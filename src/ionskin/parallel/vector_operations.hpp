// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/parallel/worker_team.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace ionskin::parallel {

/// Reductions and updates of long vectors on several threads; the vectors of one call have the same
/// length. Sums are formed per segment and added in a fixed order, so that results are identical
/// bit for bit on any number of threads.
class VectorOperations {
public:
  explicit VectorOperations(WorkerTeam& team) : team_(team) {}

  /// Scalar product of `a` and `b`.
  double dot(std::span<const double> a, std::span<const double> b);
  /// Euclidean norm.
  double norm(std::span<const double> a);
  /// Largest |a_i|; NaN if an entry is not finite.
  double largest_magnitude(std::span<const double> a);
  /// y += factor x
  void add(double factor, std::span<const double> x, std::span<double> y) const;
  /// y = x + factor d
  void combine(std::span<const double> x, double factor, std::span<const double> d,
               std::span<double> y) const;
  /// Subtracts from `vector` its projections on the first `count` vectors of an orthonormal `basis`
  /// (classical Gram-Schmidt in two sweeps over memory: scalar products, then subtraction).
  /// @param coefficients receives the `count` scalar products with the basis vectors
  /// @returns the Euclidean norm of the remainder
  double orthogonalise(const std::vector<std::vector<double>>& basis, std::size_t count,
                       std::span<double> vector, std::span<double> coefficients);
  /// y = factor x
  void scale(double factor, std::span<const double> x, std::span<double> y) const;

private:
  /// Calls `body(segment, begin, end)` for each segment of fixed length in [0, length).
  template <class Body> void for_segments(std::size_t length, const Body& body) const;
  /// Sum of the first `parts` entries of `partial_`, in their order.
  double sum_partial(std::size_t parts) const;

  WorkerTeam& team_;
  /// Sums of the segments, before they are added up.
  std::vector<double> partial_;
};

} // namespace ionskin::parallel
