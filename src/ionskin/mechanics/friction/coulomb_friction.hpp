// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/mechanics/friction/friction_law.hpp"

namespace ionskin::mechanics {

/// Coulomb's law of dry friction: |tangential traction| <= mu * normal traction, with equality and
/// along the slip where there is slip.
struct CoulombFriction {
  double coefficient = 0; ///< mu [1]

  /// Largest tangential traction [Pa]; 0 in tension.
  double limit(const FrictionArguments& at) const;
  /// Derivative of the limit by the normal traction [1].
  double limit_slope(const FrictionArguments& at) const;
};

} // namespace ionskin::mechanics
