// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/laws/friction/friction_law.hpp"

#include <array>

namespace ionskin::laws {

/// Friction law `saturating`: |t| <= mu p / (1 + (mu p / s)^n)^(1/n), which is Coulomb's law at low
/// normal traction p, and the shear strength s of the interface at high p. The transition is
/// smooth, and sharper for larger n; as n tends to infinity the limit tends to min(mu p, s) (Shaw
/// 1963, Int. J. Mech. Sci. 5; the limit shear stress of contact codes).
struct SaturatingFriction {
  double coefficient = 0; ///< mu [1]
  double strength = 0;    ///< s [Pa]
  double sharpness = 0;   ///< n [1]

  static constexpr auto parameters() {
    return std::array{OwnParameter<SaturatingFriction>{
                          {.name = "strength",
                           .dimension = units::Dimension::stress,
                           .lowest = 1,
                           .highest = 1e12,
                           .help = "Shear strength of the interface, which no friction exceeds."},
                          &SaturatingFriction::strength},
                      OwnParameter<SaturatingFriction>{{.name = "sharpness",
                                                        .lowest = 1,
                                                        .highest = 20,
                                                        .help = "How sharply friction saturates.",
                                                        .default_value = "2",
                                                        .source = "an assumption"},
                                                       &SaturatingFriction::sharpness}};
  }
  /// Largest tangential traction [Pa]; 0 in tension.
  double limit(const FrictionArguments& at) const;
  /// Derivative of the limit with respect to the normal traction [1].
  double limit_slope(const FrictionArguments& at) const;
};

} // namespace ionskin::laws
