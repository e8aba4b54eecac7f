// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/laws/friction/friction_law.hpp"

#include <array>

namespace ionskin::laws {

/// Friction law `stribeck`, static and kinetic friction:
///   |t| <= (mu_k + (mu - mu_k) exp(-(v / v_s)^2)) p,
/// with the static coefficient mu at rest and the kinetic coefficient mu_k well above the Stribeck
/// speed v_s (Bo and Pavelescu 1982, Wear 82). The speed v follows the slip speed with a lag,
/// dv/dt = (v_slip - v) / T, the frictional memory of Armstrong-Helouvry, Dupont and Canudas de Wit
/// 1994, doi 10.1016/0005-1098(94)90209-7. Without the lag, friction that falls with speed would
/// have no solution to which time steps converge, as the skin has no mass.
struct StribeckFriction {
  double coefficient = 0;      ///< mu, static [1]
  double kinetic_friction = 0; ///< mu_k [1]
  double stribeck_speed = 0;   ///< v_s [m/s]
  double lag_time = 0;         ///< T [s]

  static constexpr auto parameters() {
    return std::array{
        OwnParameter<StribeckFriction>{
            {.name = "kinetic_friction",
             .lowest = 0,
             .highest = 2,
             .help = "Coefficient of fast sliding; contact.friction is that of rest."},
            &StribeckFriction::kinetic_friction},
        OwnParameter<StribeckFriction>{
            {.name = "stribeck_speed",
             .dimension = units::Dimension::speed,
             .lowest = 1e-9,
             .highest = 1e3,
             .help = "Speed of sliding by which most of the way from static to kinetic friction "
                     "is gone."},
            &StribeckFriction::stribeck_speed},
        OwnParameter<StribeckFriction>{
            {.name = "lag_time",
             .dimension = units::Dimension::time,
             .lowest = 1e-6,
             .highest = 1e4,
             .help = "Time by which friction lags behind the speed.",
             .default_value = "\"5 ms\"",
             .source = "3 to 9 ms were measured in lubricated contacts (Hess and Soom 1990, J. "
                       "Tribology 112)"},
            &StribeckFriction::lag_time}};
  }
  /// Largest tangential traction [Pa]; 0 in tension.
  double limit(const FrictionArguments& at) const;
  /// Derivative of the limit with respect to the normal traction [1].
  double limit_slope(const FrictionArguments& at) const;
  /// Time constant of the lagged speed, T [s].
  double lag() const { return lag_time; }
};

} // namespace ionskin::laws
