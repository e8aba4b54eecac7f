// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/coulomb_friction.hpp"

#include <algorithm>
#include <cmath>

namespace ionskin::mechanics {

double CoulombFriction::limit(const FrictionArguments& at) const {
  return coefficient * std::max(0.0, at.normal_traction);
}

double CoulombFriction::limit_slope(const FrictionArguments& at) const {
  return at.normal_traction > 0 ? coefficient : 0.0;
}

std::array<double, 2> project_on_disc(const std::array<double, 2>& traction, double limit) {
  const double length = std::hypot(traction[0], traction[1]);
  if (length <= limit) {
    return traction;
  }
  return {traction[0] * limit / length, traction[1] * limit / length};
}

} // namespace ionskin::mechanics
