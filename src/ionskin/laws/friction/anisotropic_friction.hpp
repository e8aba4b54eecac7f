// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/laws/friction/friction_law.hpp"

#include <array>

namespace ionskin::laws {

/// Friction law `anisotropic`, for a surface with a grain: (t_x / mu_x)^2 + (t_y / mu_y)^2 <= p^2,
/// an ellipse with coefficients along x and y of the skin. Slip is normal to the ellipse (maximum
/// dissipation, Michalowski and Mroz 1978, Arch. Mech. 30): in sliding along a unit vector d,
/// t = p (mu_x^2 d_x, mu_y^2 d_y) / sqrt(mu_x^2 d_x^2 + mu_y^2 d_y^2).
struct AnisotropicFriction {
  double coefficient = 0;         ///< mu_x [1]
  double transverse_friction = 0; ///< mu_y [1]

  static constexpr auto parameters() {
    return std::array{OwnParameter<AnisotropicFriction>{
        {.name = "transverse_friction",
         .lowest = 1e-3,
         .highest = 2,
         .help = "Coefficient of friction along y; contact.friction is that along x."},
        &AnisotropicFriction::transverse_friction}};
  }
  /// Largest traction along x [Pa]; 0 in tension.
  double limit(const FrictionArguments& at) const;
  /// Derivative of the limit along x with respect to the normal traction [1].
  double limit_slope(const FrictionArguments& at) const;
  /// Ratio of the limit along y to the limit along x, mu_y / mu_x [1].
  double across() const { return transverse_friction / coefficient; }
};

} // namespace ionskin::laws
