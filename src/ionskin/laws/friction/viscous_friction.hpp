// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/laws/friction/friction_law.hpp"

#include <array>

namespace ionskin::laws {

/// Friction in proportion to speed: |t| = mu p v / v0 against the sliding with speed v, so that the
/// coefficient mu is that at the reference speed v0. Nothing sticks: under a resting slider the
/// traction relaxes. The viscous part of friction models (Olsson, Astrom, Canudas de Wit, Gafvert
/// and Lischinsky 1998, doi 10.1016/S0947-3580(98)70113-X), for a contact that opens and closes.
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
  /// Tangential traction while sliding [Pa]; 0 in tension, and where the time step is 0.
  double limit(const FrictionArguments& at) const;
  /// Derivative of the limit by the normal traction [1].
  double limit_slope(const FrictionArguments& at) const;
  /// Derivative of the limit by the slip of the step [Pa/m].
  double limit_slip_slope(const FrictionArguments& at) const;
};

} // namespace ionskin::laws
