// SPDX-License-Identifier: Apache-2.0
#include "ionskin/laws/friction/saturating_friction.hpp"

#include <cmath>

namespace ionskin::laws {

double SaturatingFriction::limit(const FrictionArguments& at) const {
  if (at.normal_traction <= 0) {
    return 0.0;
  }
  const double sliding = coefficient * at.normal_traction;
  if (sliding > strength) { // the power of a ratio below 1 does not overflow
    return strength / std::pow(1 + std::pow(strength / sliding, sharpness), 1 / sharpness);
  }
  return sliding / std::pow(1 + std::pow(sliding / strength, sharpness), 1 / sharpness);
}

double SaturatingFriction::limit_slope(const FrictionArguments& at) const {
  if (at.normal_traction <= 0) {
    return 0.0;
  }
  return coefficient * std::pow(limit(at) / (coefficient * at.normal_traction), 1 + sharpness);
}

} // namespace ionskin::laws
