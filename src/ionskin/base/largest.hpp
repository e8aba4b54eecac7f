// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <span>

namespace ionskin::base {

/// Larger of two numbers, or NaN if one of them is NaN. `std::max` can drop a NaN, so that a
/// solution that has broken down would pass for converged.
constexpr double nan_max(double a, double b) {
  return a < b || b != b ? b : a; // a comparison with NaN is false: a NaN stays
}

/// Largest magnitude of some numbers; NaN if one of them is NaN, 0 if there are none.
inline double largest_magnitude(std::span<const double> values) {
  double largest = 0;
  for (const double value : values) {
    largest = nan_max(largest, std::abs(value));
  }
  return largest;
}

} // namespace ionskin::base
