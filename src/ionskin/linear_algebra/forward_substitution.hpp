// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/linear_algebra/sparse_matrix.hpp"

#include <cstddef>
#include <vector>

namespace ionskin::linear_algebra {

struct CholeskyPanels;

/// Loads B on few unknowns each, by columns.
struct SparseLoads {
  std::vector<int> start{0}; ///< of the entries of each load, and their end
  std::vector<int> place;    ///< in the elimination order
  std::vector<double> value;

  int count() const { return static_cast<int>(start.size()) - 1; }
};

/// Forward substitution Y = L^-1 B through all but the trailing unknowns. A load reaches the panels
/// of the factor on its path through the elimination tree alone (Gilbert and Peierls 1988, doi
/// 10.1137/0909058): only there is Y kept.
class ForwardSubstitution {
public:
  ForwardSubstitution(const CholeskyPanels& panels, int trailing, const SparseLoads& loads);

  /// Y^T Y, both triangles: compliance where the trailing unknowns are held.
  DenseMatrix gram() const;
  /// Load that the trailing unknowns are left with [trailing, loads].
  const DenseMatrix& passed_on() const { return passed_on_; }

  // Values of states side by side for each unknown, as `Cholesky::complete` takes them: shape
  // [states, at least the unknowns before the trailing ones].

  /// Y of some loads, one in each state.
  void select(const std::vector<int>& loads, DenseMatrix& states) const;
  /// Y times weights [loads, states].
  void combine(const DenseMatrix& weights, DenseMatrix& states) const;

private:
  /// Of the unknowns of one panel, for the sorted loads from one on.
  struct Piece {
    std::size_t panel = 0;
    int first_unknown = 0, first_load = 0;
    DenseMatrix values; ///< [unknowns, loads]
  };
  /// Of zeros, where loads reach. @returns the piece of each unknown
  std::vector<std::size_t> make_pieces(const CholeskyPanels& panels, const SparseLoads& loads);
  /// Calls `use` with each piece; what lies between them is set to zero.
  template <class Use> void for_pieces(DenseMatrix& states, const Use& use) const;

  int unknowns_;            ///< before the trailing ones
  std::vector<int> sorted_; ///< loads by the first unknown that they act on: so they reach ranges
  std::vector<Piece> pieces_;
  DenseMatrix passed_on_;
};

} // namespace ionskin::linear_algebra
