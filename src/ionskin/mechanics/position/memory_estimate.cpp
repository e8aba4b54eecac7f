// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/position/memory_estimate.hpp"

#include <algorithm>
#include <cmath>

namespace ionskin::mechanics {
namespace {

constexpr double factor_share = 0.56; // of what a position takes; measured with the preset coarse

} // namespace

// Measured on cases/paper.toml at 45e3, 54e3 and 114e3 unknowns; the power fits the three within
// 10 %.
double factorisation_memory(std::size_t unknowns) {
  return 0.94e9 * std::pow(static_cast<double>(unknowns) / 1e5, 1.25);
}

double factorisations_memory(std::size_t unknowns, int threads) {
  const double each = factorisation_memory(unknowns);
  const double held = std::floor(memory_for_factors / (factor_share * each));
  return each * std::clamp(held, 1.0, static_cast<double>(threads));
}

} // namespace ionskin::mechanics
