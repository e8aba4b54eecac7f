// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

namespace ionskin::live {

/// Weights that advance a first-order state, dy/dt = rate (drive - y), over a time step in which
/// the drive is linear in time. The result is exact.
struct LowPass {
  double decay = 1; ///< weight of the state at the beginning of the step [1]
  /// Weights of the drive at the beginning and at the end of the step [1].
  double before = 0, now = 0;

  /// Computes the weights for a step.
  /// @param rate [1/s]
  /// @param step duration [s]
  static LowPass over(double rate, double step) noexcept {
    const double z = rate * step, decay = std::exp(-z),
                 mean = z > 1e-8 ? -std::expm1(-z) / z : 1 - z / 2;
    return {decay, mean - decay, 1 - mean};
  }

  /// Advances the state over the step, and returns it at the end.
  /// @param state at the beginning of the step
  /// @param from, to drive at the beginning and at the end of the step
  double next(double state, double from, double to) const noexcept {
    return decay * state + before * from + now * to;
  }
};

} // namespace ionskin::live
