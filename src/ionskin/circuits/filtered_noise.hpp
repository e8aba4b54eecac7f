// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <random>

namespace ionskin::circuits {

/// Generator of white noise behind a first-order low pass: with the one-sided density S and the
/// bandwidth B, an Ornstein-Uhlenbeck process of time constant 1/(2 pi B) and variance S^2 B pi/2.
/// Value and integral over a step are drawn from their exact joint distribution, however long the
/// step (Gillespie 1996, doi 10.1103/PhysRevE.54.2084). The same seed gives the same noise on every
/// machine.
class FilteredNoise {
public:
  /// @param density one-sided amplitude density S, in the unit of the signal [unit/sqrt(Hz)]
  /// @param bandwidth -3 dB bandwidth B of the low pass [Hz]
  /// @param seed of the random numbers
  FilteredNoise(double density, double bandwidth, std::uint64_t seed);

  /// Noise at the present instant [unit]; stationary from the start.
  double value() const { return value_; }
  /// Advances the noise by `duration` [s] and returns its integral over that time [unit s].
  double advance(double duration);

private:
  double normal();

  double time_constant_, deviation_;
  std::mt19937_64 generator_;
  std::optional<double> spare_;
  double value_ = 0;
};

} // namespace ionskin::circuits
