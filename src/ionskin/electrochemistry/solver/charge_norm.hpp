// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/electrochemistry/grid/scaled_grid.hpp"
#include "ionskin/electrochemistry/output/ion_state.hpp"

#include <array>
#include <span>
#include <vector>

namespace ionskin::electrochemistry {

/// Measures of the electrodes' charge per area [F c0 lambda], by which the time steps are
/// controlled: charge is what the program reports, and its error is smooth where that of a
/// concentration is not.
class ChargeNorm {
public:
  explicit ChargeNorm(const ScaledGrid& grid);

  /// Weights per level with which a change of concentration moves charge to the top and to the
  /// bottom at constant potentials of the electrodes (theorem of Ramo, see `ramo_charge_top`).
  const std::array<std::vector<double>, 2>& weights() const { return weights_; }

  /// Size of the charge that a change moves: the mean over the columns of half the difference
  /// between the electrodes, or shares of the root mean squares over the columns of that and of
  /// half the sum, whichever is largest. Where the slider passes, columns have errors that cancel
  /// in the mean as long as the response is linear.
  /// @param charges of every column, moved to the top and to the bottom
  /// @param column_share of the differences; the sums, which are larger, count a fifth of it
  static double of_change(const std::array<std::vector<double>, 2>& charges, double column_share);

  /// Size of the charge of a state: the mean over the columns of half the difference between the
  /// electrodes, as it is or at equal potentials (an open circuit keeps it at nothing), or a tenth
  /// of the root mean square over the columns of the difference, or a hundredth of that of all
  /// charges, whichever is largest.
  double of_state(const IonState& state, std::span<const double> fixed_charge) const;

private:
  const ScaledGrid& grid_;
  std::array<std::vector<double>, 2> weights_;
};

} // namespace ionskin::electrochemistry
