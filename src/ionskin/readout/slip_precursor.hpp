// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/readout/slip_onset.hpp"

#include <optional>
#include <vector>

namespace ionskin::readout {

/// Threshold for a change of current to count as seen, in multiples of the noise of a reading [1].
inline constexpr double seen_above_noise = 3;

/// Precursor of slip in one current: its change between the first micro-slip and full slip. A
/// reading is the charge gained over the last readout interval divided by the interval,
/// docs/model.md (30), taken at any instant, since it is chance where the readings of a run fall.
/// Readings that contain charge from before the slide do not count.
struct SlipPrecursor {
  /// Largest departure of a reading from the first one that counts [A]; empty if none counts.
  std::optional<double> departure;
  /// Time from the instant at which a reading departs by `seen_above_noise` times the noise until
  /// full slip [s]; empty if none does.
  std::optional<double> lead_time;
  /// Largest charge that has passed since the first micro-slip, by magnitude [C].
  double charge = 0;
  /// Pearson's correlation coefficient of current and sticking share, weighted by time [1]; empty
  /// where one of them does not change.
  std::optional<double> correlation;
};

/// Computes the precursor of slip from the record of one current.
/// @param time of the rows [s]
/// @param charge integral of the current, linear between the rows [row] [C]
/// @param stick_share sticking share of the contact area, 0 to 1 [row]
/// @param onset of slip; must include full slip
/// @param interval of the readout [s]
/// @param noise rms noise of a reading [A]
SlipPrecursor slip_precursor(const std::vector<double>& time, const std::vector<double>& charge,
                             const std::vector<double>& stick_share, const SlipOnset& onset,
                             double interval, double noise);

} // namespace ionskin::readout
