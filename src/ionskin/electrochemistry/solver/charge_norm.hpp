// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/electrochemistry/grid/scaled_grid.hpp"
#include "ionskin/electrochemistry/output/ion_state.hpp"

#include <array>
#include <span>
#include <vector>

namespace ionskin::electrochemistry {

/// Norms of the electrodes' charge per area [F c0 lambda] that control the time steps: charge is
/// what the program reports, and its error is smooth where the error of a concentration is not.
class ChargeNorm {
public:
  explicit ChargeNorm(const ScaledGrid& grid);

  /// Weights per z level with which a change of concentration moves charge to the top and to the
  /// bottom electrode at constant potentials (theorem of Ramo, see `ramo_charge_top`), [top,
  /// bottom][level].
  const std::array<std::vector<double>, 2>& weights() const { return weights_; }

  /// Norm of a change of charge: the largest of the mean over the columns of half the difference
  /// between the electrodes, of `column_share` times the root mean square of that over the columns,
  /// and of a fifth of `column_share` times the root mean square of half the sum. Single columns
  /// count because their errors, where the slider passes, cancel in the mean as long as the
  /// response is linear.
  /// @param charges per area moved to the top and to the bottom electrode in every column, [top,
  ///   bottom][y][x]
  /// @param column_share weight of the errors of single columns [1]
  static double of_change(const std::array<std::vector<double>, 2>& charges, double column_share);

  /// Norm of the charge of a state: the largest of the mean over the columns of half the difference
  /// between the electrodes, of that mean at equal potentials (the first stays at 0 in an open
  /// circuit), of a tenth of the root mean square of the difference over the columns, and of a
  /// hundredth of the root mean square of all charges.
  /// @param fixed_charge cf/c0 [nodes]
  double of_state(const IonState& state, std::span<const double> fixed_charge) const;

private:
  const ScaledGrid& grid_;
  std::array<std::vector<double>, 2> weights_;
};

} // namespace ionskin::electrochemistry
