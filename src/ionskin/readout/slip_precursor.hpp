// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/readout/slip_onset.hpp"

#include <optional>
#include <vector>

namespace ionskin::readout {

/// Number of times the noise of a reading by which a current departs to count as seen.
inline constexpr double seen_above_noise = 3;

/// Precursor that one current shows of a slip between its first micro-slip and full slip. A reading
/// is the charge gained over the last readout interval divided by it, docs/model.md (30), at any
/// instant: where the readings of a run fall is chance. Readings that hold some of what was before
/// the slide do not count.
struct SlipPrecursor {
  /// The largest, of a reading from the first that counts [A]; none where none does.
  std::optional<double> departure;
  /// Time from where the reading has departed by `seen_above_noise` times the noise to full slip
  /// [s]; none where it never does.
  std::optional<double> lead_time;
  double charge = 0; ///< the largest that has passed since the first micro-slip [C]
  /// Pearson's coefficient of the current with the stuck share, weighted by time; none where one of
  /// them does not change.
  std::optional<double> correlation;
};

/// Precursor of a slide in the record of one current.
/// @param time of the rows [s]
/// @param charge of the current [C], linear between the rows
/// @param stick_share at the rows
/// @param onset with full slip
/// @param interval of the readout [s]
/// @param noise rms of a reading [A]
SlipPrecursor slip_precursor(const std::vector<double>& time, const std::vector<double>& charge,
                             const std::vector<double>& stick_share, const SlipOnset& onset,
                             double interval, double noise);

} // namespace ionskin::readout
