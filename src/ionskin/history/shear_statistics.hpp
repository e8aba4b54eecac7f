// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/history/core_history.hpp"

namespace ionskin::history {

/// Scalars of the shear at one instant, volume weighted over the whole core. Percentiles and
/// maximum are of the magnitude, so that they tell how large a shear of either sign is.
struct ShearStatistics {
  double mean = 0;         ///< [1]
  double rms = 0;          ///< [1]
  double p95 = 0, p99 = 0; ///< percentiles by volume, over averages of z intervals of cells [1]
  double first_moment = 0; ///< mean of gamma (zeta/h - 1/2) [1]
  double element_max = 0;  ///< largest average over one z interval of one cell [1]
};

/// Statistics of the shear at an instant of a history.
/// @param time [s] within the history
/// Mean, first moment (docs/model.md (11)) and rms are exact for the piecewise-linear form. All are
/// NaN in a history without shear.
ShearStatistics shear_statistics(const CoreHistory& history, double time);

/// Integral of gamma over the core [m3], exact for the piecewise-linear form.
double shear_integral(const CoreHistory& history, double time);

/// Integrals over the core of a channel [its unit times m3], exact for the piecewise-linear form.
struct ChannelIntegrals {
  double value = 0;     ///< of the channel
  double magnitude = 0; ///< of its magnitude
};

ChannelIntegrals channel_integrals(const CoreHistory& history, const HistoryChannel& channel,
                                   double time);

} // namespace ionskin::history
