// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace ionskin::live {

/// Newton's step for the normal forces of the cells that touch, dense and without pivots: the
/// normal compliance is positive definite, and friction adds little to it. Single precision, since
/// sweeps follow that take the remaining residual. Nothing is allocated after construction.
class NormalCorrection {
public:
  explicit NormalCorrection(std::size_t cells);

  /// True if `factor` was last called for these cells since `forget`.
  bool is_of(std::span<const std::size_t> cells) const noexcept;
  void forget() noexcept { count_ = 0; }
  /// Takes the cells; then `column(j)` is to be filled with the normal displacements of all of them
  /// for a unit normal force, and its friction, on cell j, before `factor`.
  void take(std::span<const std::size_t> cells) noexcept;
  std::span<float> column(std::size_t j) noexcept { return {matrix_.data() + j * count_, count_}; }
  /// Factorises the matrix of the columns that were filled.
  /// @returns false when the matrix is none of a contact; it is forgotten then
  bool factor() noexcept;
  /// Solves for the forces on the cells, in place.
  /// @param values displacements in, forces out
  void solve(std::span<float> values) const noexcept;

private:
  std::vector<float> matrix_; ///< [column][row], both triangles after `factor`
  std::vector<std::size_t> cells_;
  std::size_t count_ = 0;
};

} // namespace ionskin::live
