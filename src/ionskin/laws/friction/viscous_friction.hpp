// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/laws/friction/friction_law.hpp"

#include <array>

namespace ionskin::laws {

/// Friction law `viscous`, friction in proportion to speed: |t| = mu p v / v0 at the slip speed v,
/// so that mu is the coefficient at the reference speed v0. No cell sticks: under a resting slider
/// the traction relaxes to zero. It is the viscous part of friction models (Olsson, Astrom, Canudas
/// de Wit, Gafvert and Lischinsky 1998, doi 10.1016/S0947-3580(98)70113-X), for a contact that
/// opens and closes.
struct ViscousFriction {
  double coefficient = 0;     ///< mu [1]
  double reference_speed = 0; ///< v0 [m/s]

  static constexpr auto parameters() {
    return std::array{OwnParameter<ViscousFriction>{
        {.name = "reference_speed",
         .dimension = units::Dimension::speed,
         .lowest = 1e-9,
         .highest = 1e3,
         .help = "Speed of sliding at which friction has its coefficient."},
        &ViscousFriction::reference_speed}};
  }
  /// Tangential traction at the slip speed slip increment / time step [Pa]; 0 in tension, and if
  /// the time step is 0.
  double limit(const FrictionArguments& at) const;
  /// Derivative of the limit with respect to the normal traction [1].
  double limit_slope(const FrictionArguments& at) const;
  /// Derivative of the limit with respect to the slip increment [Pa/m].
  double limit_slip_slope(const FrictionArguments& at) const;
};

} // namespace ionskin::laws
