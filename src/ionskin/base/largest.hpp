// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace ionskin::base {

/// The larger of two numbers, or NaN where one is NaN. std::max drops it, so that what has broken
/// down passes for converged.
constexpr double larger(double a, double b) {
  return a < b || b != b ? b : a; // a comparison with NaN is false: a NaN stays
}

} // namespace ionskin::base
