// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace ionskin::live {

/// Newton's step for the tangential forces of the cells that touch, by conjugate gradients: along
/// each direction in which friction lets a cell's force follow its slip, the surfaces move until
/// the slip is what the law allows. Sweeps by themselves need hundreds where a soft slider sticks.
/// Single precision, since sweeps follow that take the remaining residual. Nothing is allocated
/// after construction.
class TangentialCorrection {
public:
  explicit TangentialCorrection(std::size_t cells);

  void clear() noexcept { count_ = 0; }
  /// A cell with its diagonal compliance [m/N], the derivative of its friction by the trial force,
  /// which is symmetric, and what the law would change of its force [N].
  void add(std::size_t cell, double own, const std::array<std::array<double, 2>, 2>& by_trial,
           const std::array<double, 2>& defect) noexcept;

  /// Takes the compliance between the cells.
  /// @param column of the force `at` of a cell, [3 cells] [m/N]
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
  /// Solves; then `change(i)` is the change of the force of `cell(i)` [N].
  void solve() noexcept;
  /// Factors the compliance, for many right sides. @returns false when it is none of a contact
  bool factor() noexcept;
  /// Solves as `solve` does, by the factors, for other defects of the cells.
  /// @param defect of the force of a cell along x and y, called with the cell
  template <class Defect> void solve_factored(const Defect& defect) noexcept {
    for (std::size_t i = 0; i < count_; ++i) {
      const Direction& own = directions_[i];
      const std::array<double, 2> of_cell = defect(own.cell);
      change_[i] = own.by_defect * static_cast<float>(static_cast<double>(own.x) * of_cell[0] +
                                                      static_cast<double>(own.y) * of_cell[1]);
    }
    substitute();
  }
  std::array<double, 2> direction(std::size_t i) const {
    return {static_cast<double>(directions_[i].x), static_cast<double>(directions_[i].y)};
  }
  std::size_t count() const { return count_; }
  std::size_t cell(std::size_t i) const { return directions_[i].cell; }
  std::array<double, 2> change(std::size_t i) const;

private:
  struct Direction {
    std::size_t cell = 0;
    float x = 0, y = 0;
    float stiffening = 0; ///< beside the skin and the slider [m/N]
    float slip = 0;       ///< slip that is to go [m]
    float by_defect = 0;  ///< derivative of that slip by the defect of the force [m/N]
  };
  void substitute() noexcept;
  std::vector<Direction> directions_;
  std::size_t count_ = 0;
  std::vector<float> matrix_; ///< [column][row], symmetric; below the diagonal after `factor`
  std::vector<float> change_, residual_, search_, product_;
};

} // namespace ionskin::live
