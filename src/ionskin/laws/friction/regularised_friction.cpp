// SPDX-License-Identifier: Apache-2.0
#include "ionskin/laws/friction/regularised_friction.hpp"

#include <algorithm>

namespace ionskin::laws {

double RegularisedFriction::limit(const FrictionArguments& at) const {
  return limit_slope(at) * std::max(0.0, at.normal_traction);
}

double RegularisedFriction::limit_slope(const FrictionArguments& at) const {
  if (at.normal_traction <= 0) {
    return 0.0;
  }
  const double share = at.time_step > 0 ? std::min(at.slip_increment / slip_length, 1.0) : 1.0;
  return coefficient * share;
}

double RegularisedFriction::limit_slip_slope(const FrictionArguments& at) const {
  const bool elastic = at.time_step > 0 && at.slip_increment < slip_length;
  return elastic ? coefficient * std::max(0.0, at.normal_traction) / slip_length : 0.0;
}

} // namespace ionskin::laws
