// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/linear_algebra/sparse_matrix.hpp"

#include <memory>
#include <vector>

namespace ionskin::linear_algebra {

/// The symbolic factorisation P A P^T = L L^T of one sparsity pattern, shared by all matrices with
/// it. The last `trailing` unknowns of the elimination order form the trailing block L22 of L.
class SymbolicCholesky {
public:
  /// @param order elimination order of all unknowns, postordered
  /// @param trailing how many unknowns at its end form the trailing block
  SymbolicCholesky(SymmetricPattern pattern, std::vector<int> order, int trailing);
  SymbolicCholesky(SymbolicCholesky&&) noexcept;
  ~SymbolicCholesky();

  const SymmetricPattern& pattern() const { return pattern_; }
  const std::vector<int>& order() const { return order_; }
  int trailing() const { return trailing_; }
  /// Entries of L, and floating point operations of one factorisation.
  double factor_entries() const;
  double operations() const;

private:
  friend class Cholesky;
  struct Symbols;
  SymmetricPattern pattern_;
  std::vector<int> order_;
  int trailing_ = 0;
  std::unique_ptr<Symbols> symbols_;
};

/// The factorisation of one matrix; several may be made and used at once, each by one thread.
class Cholesky {
public:
  /// @param values entries of the lower triangle in the order of the symbolic pattern
  /// @param threads of its dense kernels
  /// Throws SolverError when the matrix is not positive definite.
  Cholesky(const SymbolicCholesky& symbolic, const std::vector<double>& values, int threads = 1);
  ~Cholesky();

  /// Solves A X = B; shapes [size, any].
  DenseMatrix solve(DenseMatrix right_hand_sides) const;

  /// L22^-1 B, shapes [trailing, any]. For loads F = S B on the trailing unknowns (S selects them)
  /// the compliance S^T A^-1 S is L22^-T L22^-1, so the Gram matrix of this result is B^T S^T A^-1
  /// S B.
  DenseMatrix trailing_forward(DenseMatrix trailing_loads) const;

  /// Completes the solution for loads on trailing unknowns only: X = A^-1 S B from Y = L22^-1 B, by
  /// backward substitution alone. Shapes [trailing, any] to [size, any], in the matrix's own
  /// numbering.
  DenseMatrix backward_from_trailing(const DenseMatrix& forward) const;

private:
  struct Numbers;
  const SymbolicCholesky& symbolic_;
  int threads_;
  std::unique_ptr<Numbers> numbers_;
  DenseMatrix trailing_block_; ///< L22, lower triangle
};

/// Y^T Y, both triangles.
DenseMatrix gram(const DenseMatrix& y);
/// A B.
DenseMatrix multiply(const DenseMatrix& a, const DenseMatrix& b);

} // namespace ionskin::linear_algebra
