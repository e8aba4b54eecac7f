// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace ionskin::live {

/// Newton step for the tangential forces of the cells in contact, by conjugate gradients or by
/// Cholesky factors. The unknowns are force components along the directions in which the friction
/// law lets a cell's force follow its slip; the solution moves the surfaces until the slip is what
/// the law allows. Without this step, hundreds of sweeps are needed where a soft slider sticks.
/// Single precision, since the sweeps that follow remove the remaining residual. Nothing is
/// allocated after construction.
class TangentialCorrection {
public:
  /// Reserves memory for contacts of at most `cells` cells.
  explicit TangentialCorrection(std::size_t cells);

  /// Removes all cells.
  void clear() noexcept { count_ = 0; }
  /// Adds a cell in contact, with up to two unknowns.
  /// @param own diagonal compliance of the cell [m/N]
  /// @param by_trial derivative of the friction force by the trial force, symmetric [1]
  /// @param defect force that the friction law gives, minus the present force [N]
  void add(std::size_t cell, double own, const std::array<std::array<double, 2>, 2>& by_trial,
           const std::array<double, 2>& defect) noexcept;

  /// Sets up the matrix from the compliance between the cells.
  /// @param column called with an index of [3 cells]; returns the displacements [3 cells] under a
  /// unit force there [m/N]
  template <class Column> void take(const Column& column) noexcept {
    for (std::size_t j = 0; j < count_; ++j) {
      const Direction& from = directions_[j];
      const float *x = column(3 * from.cell + 1), *y = column(3 * from.cell + 2);
      float* into = matrix_.data() + j * count_;
      for (std::size_t i = j; i < count_; ++i) {
        const Direction& to = directions_[i];
        const std::size_t row = 3 * to.cell;
        into[i] = matrix_[i * count_ + j] = to.x * (from.x * x[row + 1] + from.y * y[row + 1]) +
                                            to.y * (from.x * x[row + 2] + from.y * y[row + 2]);
      }
      into[j] += from.stiffening;
    }
  }
  /// Solves by conjugate gradients. Then `change(i)` is the change of the force of `cell(i)` [N].
  void solve() noexcept;
  /// Factorises the matrix (Cholesky), for many right-hand sides.
  /// @returns false if the matrix is not positive definite
  bool factor() noexcept;
  /// Solves as `solve` does, with the factors, for other defects.
  /// @param defect called with a cell; returns the defect of its force along x and y
  template <class Defect> void solve_factored(const Defect& defect) noexcept {
    for (std::size_t i = 0; i < count_; ++i) {
      const Direction& own = directions_[i];
      const std::array<double, 2> of_cell = defect(own.cell);
      change_[i] = own.by_defect * static_cast<float>(static_cast<double>(own.x) * of_cell[0] +
                                                      static_cast<double>(own.y) * of_cell[1]);
    }
    substitute();
  }
  /// Direction of an unknown along x and y, of length 1.
  std::array<double, 2> direction(std::size_t i) const {
    return {static_cast<double>(directions_[i].x), static_cast<double>(directions_[i].y)};
  }
  /// Number of unknowns, at most two for each cell.
  std::size_t count() const { return count_; }
  /// Cell of an unknown.
  std::size_t cell(std::size_t i) const { return directions_[i].cell; }
  /// Change of the force of a cell along an unknown's direction, x and y [N].
  std::array<double, 2> change(std::size_t i) const;

private:
  struct Direction {
    std::size_t cell = 0;
    float x = 0, y = 0;
    /// Compliance that the friction law adds to that of skin and slider [m/N].
    float stiffening = 0;
    float slip = 0;      ///< slip that remains to be removed [m]
    float by_defect = 0; ///< derivative of `slip` by the defect of the force [m/N]
  };
  void substitute() noexcept;
  std::vector<Direction> directions_;
  std::size_t count_ = 0;
  /// [column][row], symmetric; the lower triangle holds the factors after `factor`.
  std::vector<float> matrix_;
  std::vector<float> change_, residual_, search_, product_;
};

} // namespace ionskin::live
