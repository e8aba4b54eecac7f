// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace ionskin::live {

/// Newton step for the normal forces of the cells in contact: LU factors of the dense normal
/// compliance, without pivoting, as the matrix is positive definite and friction adds little to it.
/// Single precision, since the Gauss-Seidel sweeps that follow remove the remaining residual.
/// Nothing is allocated after construction.
class NormalCorrection {
public:
  /// Reserves memory for contacts of at most `cells` cells.
  explicit NormalCorrection(std::size_t cells);

  /// True if the factors are those of exactly these cells, and `forget` was not called since.
  bool is_of(std::span<const std::size_t> cells) const noexcept;
  /// Discards the factors.
  void forget() noexcept { count_ = 0; }
  /// Begins a matrix for some cells. The caller then fills every `column(j)`, and calls `factor`.
  /// @param cells indices of the cells in contact
  void take(std::span<const std::size_t> cells) noexcept;
  /// Column j of the matrix, to be filled: normal displacements of all cells under a unit normal
  /// force on cell j and the friction that goes with it [m/N].
  std::span<float> column(std::size_t j) noexcept { return {matrix_.data() + j * count_, count_}; }
  /// Factorises the matrix.
  /// @returns false, with the factors discarded, if a pivot is not positive
  bool factor() noexcept;
  /// Solves for the normal forces on the cells, in place.
  /// @param values displacements of the cells in [m], forces out [N]
  void solve(std::span<float> values) const noexcept;

private:
  std::vector<float> matrix_;      ///< [column][row]; L and U after `factor`
  std::vector<std::size_t> cells_; ///< cells of the matrix, in the first `count_` elements
  std::size_t count_ = 0;          ///< number of rows and columns; 0 without factors
};

} // namespace ionskin::live
