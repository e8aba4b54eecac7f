// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <random>

namespace ionskin::live {

/// Random numbers that are alike on every machine; the distributions of the standard library need
/// not be.
class Random {
public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  double between(double low, double high) {
    constexpr double range = 0x1p-53;
    return low + (high - low) * static_cast<double>(engine_() >> 11u) * range;
  }

private:
  std::mt19937_64 engine_;
};

} // namespace ionskin::live
