// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <random>

namespace ionskin::live {

/// Random number generator whose numbers are the same on every machine, unlike the distributions of
/// the standard library.
class Random {
public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  /// Uniformly distributed number from `low` to below `high`.
  double between(double low, double high) {
    constexpr double range = 0x1p-53;
    return low + (high - low) * static_cast<double>(engine_() >> 11u) * range;
  }

private:
  std::mt19937_64 engine_;
};

} // namespace ionskin::live
