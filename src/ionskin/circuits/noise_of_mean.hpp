// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

namespace ionskin::circuits {

/// Way in which an instrument averages a signal: the mean over an interval, behind a first-order
/// low pass.
struct Averaging {
  double interval = 0;  ///< averaging time T of one reading [s]
  double bandwidth = 0; ///< -3 dB bandwidth B of the low pass [Hz]
  /// Length of the record whose mean is subtracted from the readings, which removes slower noise
  /// [s]. At least `interval`.
  double record = 0;
};

/// Rms noise of an averaged reading, docs/model.md (61):
///   sqrt(int S(f) sinc^2(pi f T) / (1 + (f/B)^2) df),
/// integrated over frequencies from 1/record on.
/// @param density function that gives the one-sided power spectral density S at a frequency [Hz];
///   [U^2/Hz], where U is the unit of the reading
/// @returns [U]
double noise_of_mean(const std::function<double(double frequency)>& density,
                     const Averaging& averaging);

} // namespace ionskin::circuits
