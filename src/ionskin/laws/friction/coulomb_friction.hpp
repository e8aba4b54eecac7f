// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/laws/friction/friction_law.hpp"

namespace ionskin::laws {

/// Coulomb's law of dry friction, docs/model.md (5): |tangential traction| <= mu * normal traction,
/// with equality and along the slip where there is slip.
struct CoulombFriction {
  double coefficient = 0; ///< mu [1]

  static constexpr auto parameters() { return no_parameters<CoulombFriction>; }
  /// Largest tangential traction [Pa]; 0 in tension.
  double limit(const FrictionArguments& at) const;
  /// Derivative of the limit by the normal traction [1].
  double limit_slope(const FrictionArguments& at) const;
};

} // namespace ionskin::laws
