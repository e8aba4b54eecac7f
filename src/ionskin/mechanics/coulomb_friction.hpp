// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

namespace ionskin::mechanics {

/// What a friction law may depend on at one cell over one step.
struct FrictionArguments {
  double normal_traction = 0; ///< compression positive [Pa]
  double slip_increment = 0;  ///< length of the relative sliding in the step [m]
  double time_step = 0;       ///< [s]
};

/// Coulomb's law of dry friction: |tangential traction| <= mu * normal traction, with equality and
/// along the slip where there is slip.
struct CoulombFriction {
  double coefficient = 0; ///< mu [1]

  /// Largest tangential traction [Pa]; 0 in tension.
  double limit(const FrictionArguments& at) const;
  /// Derivative of the limit by the normal traction [1].
  double limit_slope(const FrictionArguments& at) const;
};

/// The nearest vector of length at most `limit`.
std::array<double, 2> project_on_disc(const std::array<double, 2>& traction, double limit);

} // namespace ionskin::mechanics
