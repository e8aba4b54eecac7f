// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/linear_algebra/forward_substitution.hpp"
#include "ionskin/linear_algebra/lower_triangle.hpp"
#include "ionskin/linear_algebra/renumbered_pattern.hpp"
#include "ionskin/linear_algebra/sparse_matrix.hpp"

#include <memory>
#include <vector>

namespace ionskin::linear_algebra {

/// The symbolic factorisation P A P^T = L L^T of one sparsity pattern, shared by all matrices with
/// it. The last `trailing` unknowns of the elimination order form the trailing block L22 of L.
class SymbolicCholesky {
public:
  /// @param pattern of the matrices, in the numbering of their unknowns
  /// @param order elimination order of all unknowns, postordered
  /// @param trailing how many unknowns at its end form the trailing block
  SymbolicCholesky(const SymmetricPattern& pattern, std::vector<int> order, int trailing);
  SymbolicCholesky(SymbolicCholesky&&) noexcept;
  ~SymbolicCholesky();

  int size() const { return ordered_.pattern.size; }
  const std::vector<int>& order() const { return order_; }
  int trailing() const { return trailing_; }
  /// Entries of L, and floating point operations of one factorisation.
  double factor_entries() const;
  double operations() const;

private:
  friend class Cholesky;
  struct Symbols;
  RenumberedPattern ordered_;
  std::vector<int> order_;
  int trailing_ = 0;
  std::unique_ptr<Symbols> symbols_;
};

/// The factorisation of one matrix, by one thread; several may be made and used at once.
class Cholesky {
public:
  /// @param values entries of the lower triangle in the order of the pattern that was analysed
  /// Throws SolverError when the matrix is not positive definite.
  Cholesky(const SymbolicCholesky& symbolic, const std::vector<double>& values);
  ~Cholesky();

  /// Solves A X = B; shapes [size, any].
  DenseMatrix solve(DenseMatrix right_hand_sides) const;

  /// The last `count` rows and columns of L, lower triangle, at most trailing(). Its product with
  /// its transpose is the Schur complement of these unknowns: what they feel of the others.
  DenseMatrix last_block(int count) const;
  /// The same, and gives the memory of what stands in it alone back: neither it nor `solve` can be
  /// asked for again.
  DenseMatrix take_last_block(int count);

  /// Forward substitution of loads through all but the trailing unknowns.
  ForwardSubstitution forward(const SparseLoads& loads) const;

  /// Backward substitution for any number of states at once, whose values stand side by side for
  /// each unknown: shape [states, size], in the elimination order. The last `known` columns hold
  /// the solution; from L^-1 B in the `loaded` ones before them, it makes the solution. B is zero
  /// for the unknowns before those: what their columns hold is replaced. One thread; others may
  /// complete other states at the same time.
  /// @param known at most trailing()
  void complete(int known, int loaded, DenseMatrix& states) const;

private:
  struct Numbers;
  const SymbolicCholesky& symbolic_;
  std::unique_ptr<Numbers> numbers_;
};

/// Y^T Y, both triangles.
DenseMatrix gram(const DenseMatrix& y);
/// L L^T of a square L with zeros above its diagonal.
LowerTriangle gram_of_rows(DenseMatrix l);
/// A B.
DenseMatrix multiply(const DenseMatrix& a, const DenseMatrix& b);

} // namespace ionskin::linear_algebra
