// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/history/core_history.hpp"

namespace ionskin::history {

/// Statistics of the shear gamma over the whole core at one instant, weighted by volume.
/// Percentiles and maximum are taken of the magnitude, so that they measure shear of either sign.
struct ShearStatistics {
  double mean = 0;         ///< [1]
  double rms = 0;          ///< [1]
  double p95 = 0, p99 = 0; ///< percentiles of |mean over an element|, by volume [1]
  double first_moment = 0; ///< mean of gamma (zeta/h - 1/2), zeta height in the core [1]
  /// Largest magnitude of the mean over an element, which is one x-y cell between two z nodes [1].
  double element_max = 0;
};

/// Computes statistics of the shear at an instant. Mean, first moment (docs/model.md (11)) and rms
/// are exact for the piecewise linear field. All are NaN in a history without a channel `shear`.
/// @param time [s] within the history
ShearStatistics shear_statistics(const CoreHistory& history, double time);

/// Integral of gamma over the core at an instant [m3], exact for the piecewise linear field.
/// @param time [s] within the history
double shear_integral(const CoreHistory& history, double time);

/// Integrals of a channel over the volume of the core [unit of the channel times m3], exact for the
/// piecewise linear field.
struct ChannelIntegrals {
  double value = 0;     ///< integral of the channel
  double magnitude = 0; ///< integral of its magnitude
};

/// Integrates a channel and its magnitude over the core at an instant.
/// @param time [s] within the history
ChannelIntegrals channel_integrals(const CoreHistory& history, const HistoryChannel& channel,
                                   double time);

} // namespace ionskin::history
