// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <random>

namespace ionskin::circuits {

/// White noise of one-sided density S behind a first-order low pass of bandwidth B: an
/// Ornstein-Uhlenbeck process of time constant 1/(2 pi B) and variance S^2 B pi/2. Value and
/// integral are drawn from their exact joint distribution, whatever the step (Gillespie 1996,
/// doi 10.1103/PhysRevE.54.2084). The same seed gives the same noise everywhere.
class FilteredNoise {
public:
  /// @param density [unit/sqrt(Hz)]
  /// @param bandwidth [Hz]
  FilteredNoise(double density, double bandwidth, std::uint64_t seed);

  double value() const { return value_; } ///< stationary from the start [unit]
  /// Moves on by `duration` [s]; returns the integral over it [unit s].
  double advance(double duration);

private:
  double normal();

  double time_constant_, deviation_;
  std::mt19937_64 generator_;
  std::optional<double> spare_;
  double value_ = 0;
};

} // namespace ionskin::circuits
