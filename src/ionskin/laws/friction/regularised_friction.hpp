// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/laws/friction/friction_law.hpp"

#include <array>

namespace ionskin::laws {

/// Coulomb's law with an elastic slip: the contact gives way by d before it slips,
///   t = mu p min(|z| / d, 1) z / |z|,
/// where z is what is kept of the elastic slip before the step (elastic_slip.hpp) and the slip of
/// the step; at most d of it stays elastic. Independent of rate, and Coulomb's law for d to 0. The
/// tangential stiffness of interfaces (Mindlin 1949; Jenkins' element); elastic slip of contact
/// codes (Wriggers, Computational Contact Mechanics, 2006, section 5.2).
struct RegularisedFriction {
  double coefficient = 0; ///< mu [1]
  double slip_length = 0; ///< d [m]

  static constexpr auto parameters() {
    return std::array{OwnParameter<RegularisedFriction>{
        {.name = "slip_length",
         .dimension = units::Dimension::length,
         .lowest = 1e-8,
         .highest = 1e-3,
         .help = "Elastic slip of the interface, after which friction is full.",
         .default_value = "\"1 um\"",
         .source = "an assumption"},
        &RegularisedFriction::slip_length}};
  }
  /// Largest tangential traction after an elastic slip [Pa]; that of full slip where the time step
  /// is 0.
  double limit(const FrictionArguments& at) const;
  /// Derivative of the limit by the normal traction [1].
  double limit_slope(const FrictionArguments& at) const;
  /// Derivative of the limit by the slip [Pa/m].
  double limit_slip_slope(const FrictionArguments& at) const;
  double elastic_slip() const { return slip_length; }
};

} // namespace ionskin::laws
