// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/laws/friction/friction_law.hpp"

namespace ionskin::laws {

/// Friction law `coulomb`, dry friction after Coulomb, docs/model.md (5): |t| <= mu p for
/// tangential traction t and normal traction p; where there is slip, |t| = mu p and t points along
/// the slip of the slider over the skin.
struct CoulombFriction {
  double coefficient = 0; ///< mu [1]

  static constexpr auto parameters() { return no_parameters<CoulombFriction>; }
  /// Largest tangential traction [Pa]; 0 in tension.
  double limit(const FrictionArguments& at) const;
  /// Derivative of the limit with respect to the normal traction [1].
  double limit_slope(const FrictionArguments& at) const;
};

} // namespace ionskin::laws
