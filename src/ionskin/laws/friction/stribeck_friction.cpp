// SPDX-License-Identifier: Apache-2.0
#include "ionskin/laws/friction/stribeck_friction.hpp"

#include <algorithm>
#include <cmath>

namespace ionskin::laws {

double StribeckFriction::limit(const FrictionArguments& at) const {
  return limit_slope(at) * std::max(0.0, at.normal_traction);
}

double StribeckFriction::limit_slope(const FrictionArguments& at) const {
  if (at.normal_traction <= 0) {
    return 0.0;
  }
  const double ratio = at.lagged_speed / stribeck_speed;
  return kinetic_friction + (coefficient - kinetic_friction) * std::exp(-ratio * ratio);
}

} // namespace ionskin::laws
