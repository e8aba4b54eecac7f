// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

namespace ionskin::circuits {

/// Averaging of an instrument: the mean over an interval, behind a first-order low pass.
struct Averaging {
  double interval = 0;  ///< [s]
  double bandwidth = 0; ///< of the low pass, -3 dB [Hz]
  /// Length of the record that is looked at, whose mean is taken away: slower noise does not show
  /// [s]. Not below the interval.
  double record = 0;
};

/// Rms of the noise of an averaged reading, docs/model.md (61):
/// sqrt(int S(f) sinc^2(pi f T) / (1 + (f/B)^2) df) from 1/record on.
/// @param density one-sided power density S(f) [U^2/Hz]
/// @returns [U]
double noise_of_mean(const std::function<double(double frequency)>& density,
                     const Averaging& averaging);

} // namespace ionskin::circuits
