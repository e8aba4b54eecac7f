// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/laws/friction/friction_law.hpp"

#include <array>

namespace ionskin::laws {

/// Friction law `regularised`: Coulomb friction with an elastic slip of up to d before full slip,
///   t = mu p min(|z| / d, 1) z / |z|,
/// where z is the elastic slip kept from earlier steps plus the slip of this step
/// (elastic_slip.hpp, docs/model.md (45)); at most d of z stays elastic. The law does not depend on
/// rate and tends to Coulomb's law as d tends to 0. It models the tangential stiffness of
/// interfaces (Mindlin 1949; Jenkins element) and is the elastic slip of contact codes (Wriggers,
/// Computational Contact Mechanics, 2006, section 5.2).
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
  /// Largest tangential traction at the slip `at.slip_increment`, which stands for |z| [Pa]; the
  /// limit of full slip, mu p, if the time step is 0. 0 in tension.
  double limit(const FrictionArguments& at) const;
  /// Derivative of the limit with respect to the normal traction [1].
  double limit_slope(const FrictionArguments& at) const;
  /// Derivative of the limit with respect to the slip |z| [Pa/m].
  double limit_slip_slope(const FrictionArguments& at) const;
  /// Largest elastic slip, d [m].
  double elastic_slip() const { return slip_length; }
};

} // namespace ionskin::laws
