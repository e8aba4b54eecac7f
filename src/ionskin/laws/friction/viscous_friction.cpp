// SPDX-License-Identifier: Apache-2.0
#include "ionskin/laws/friction/viscous_friction.hpp"

#include <algorithm>

namespace ionskin::laws {

double ViscousFriction::limit(const FrictionArguments& at) const {
  return limit_slope(at) * std::max(0.0, at.normal_traction);
}

double ViscousFriction::limit_slope(const FrictionArguments& at) const {
  if (at.normal_traction <= 0 || at.time_step <= 0) {
    return 0.0;
  }
  return coefficient * at.slip_increment / (at.time_step * reference_speed);
}

double ViscousFriction::limit_slip_slope(const FrictionArguments& at) const {
  if (at.normal_traction <= 0 || at.time_step <= 0) {
    return 0.0;
  }
  return coefficient * at.normal_traction / (at.time_step * reference_speed);
}

} // namespace ionskin::laws
