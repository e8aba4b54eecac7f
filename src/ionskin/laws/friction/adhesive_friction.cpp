// SPDX-License-Identifier: Apache-2.0
#include "ionskin/laws/friction/adhesive_friction.hpp"

#include <algorithm>

namespace ionskin::laws {

double AdhesiveFriction::limit(const FrictionArguments& at) const {
  return coefficient * std::max(0.0, at.normal_traction);
}

double AdhesiveFriction::limit_slope(const FrictionArguments& at) const {
  return at.normal_traction > 0 ? coefficient : 0.0;
}

} // namespace ionskin::laws
