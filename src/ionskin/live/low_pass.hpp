// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

namespace ionskin::live {

/// Weights that take a first-order state, dy/dt = rate (drive - y), over a step in which the drive
/// is linear, exactly.
struct LowPass {
  double decay = 1; ///< of the state
  double before = 0, now = 0;

  /// Weights of a step.
  /// @param rate [1/s]
  /// @param step [s]
  static LowPass over(double rate, double step) noexcept {
    const double z = rate * step, decay = std::exp(-z),
                 mean = z > 1e-8 ? -std::expm1(-z) / z : 1 - z / 2;
    return {decay, mean - decay, 1 - mean};
  }

  /// State at the end of a step.
  /// @param from, to the input at the begin and at the end of the step
  double next(double state, double from, double to) const noexcept {
    return decay * state + before * from + now * to;
  }
};

} // namespace ionskin::live
