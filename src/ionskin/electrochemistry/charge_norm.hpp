// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/electrochemistry/ion_state.hpp"
#include "ionskin/electrochemistry/scaled_grid.hpp"

#include <span>
#include <vector>

namespace ionskin::electrochemistry {

/// Measures of the electrodes' charge per area [F c0 lambda], by which the time steps are
/// controlled: charge is what the program reports, and its error is smooth where that of a
/// concentration is not.
class ChargeNorm {
public:
  explicit ChargeNorm(const ScaledGrid& grid);

  /// Charge that a change of concentration moves at constant potentials of the electrodes (theorem
  /// of Ramo, see `ramo_charge_top`): the mean over the columns of half the difference between the
  /// electrodes, or shares of the root mean squares over the columns of that and of half the
  /// sum, whichever is largest. Where the slider passes, columns have errors that cancel in the
  /// mean as long as the response is linear.
  /// @param change one value per node
  /// @param column_share of the differences; the sums, which are larger, count a fifth of it
  double of_change(std::span<const double> change, double column_share);

  /// Size of the charge of a state: the mean over the columns of half the difference between the
  /// electrodes, as it is or at equal potentials (an open circuit keeps it at nothing), or a tenth
  /// of the root mean square over the columns of the difference, or a hundredth of that of all
  /// charges, whichever is largest.
  double of_state(const IonState& state, std::span<const double> fixed_charge) const;

private:
  const ScaledGrid& grid_;
  std::vector<double> top_weight_, bottom_weight_; ///< per level
  std::vector<double> top_, bottom_;               ///< per column
};

} // namespace ionskin::electrochemistry
