// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/memory_estimate.hpp"

#include <cmath>

namespace ionskin::mechanics {

// Measured on cases/paper.toml at 45e3, 54e3 and 114e3 unknowns; the power fits the three within
// 10 %.
double factorisation_memory(std::size_t unknowns) {
  return 0.94e9 * std::pow(static_cast<double>(unknowns) / 1e5, 1.25);
}

} // namespace ionskin::mechanics
