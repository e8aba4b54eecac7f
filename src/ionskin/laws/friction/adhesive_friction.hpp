// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/laws/friction/friction_law.hpp"

#include <array>

namespace ionskin::laws {

/// Friction law `adhesive`: adhesion along the normal by a cohesive zone, with Coulomb friction in
/// compression only: |t| <= mu max(p, 0), where p < 0 is tension. Cohesive models with friction
/// have the same limit (Raous, Cangemi and Cocou 1999, doi 10.1016/S0045-7825(98)00389-2, while
/// the bond is at rest). As the strength grows, the pull-off force of a sphere tends to the value
/// of Johnson, Kendall and Roberts 1971, doi 10.1098/rspa.1971.0141.
struct AdhesiveFriction {
  double coefficient = 0;       ///< mu [1]
  double work_of_adhesion = 0;  ///< w [J/m2]
  double cohesive_strength = 0; ///< s0 [Pa]

  static constexpr auto parameters() {
    return std::array{
        OwnParameter<AdhesiveFriction>{{.name = "work_of_adhesion",
                                        .dimension = units::Dimension::surface_energy,
                                        .lowest = 1e-6,
                                        .highest = 1e4,
                                        .help = "Energy per area that parts slider and skin."},
                                       &AdhesiveFriction::work_of_adhesion},
        OwnParameter<AdhesiveFriction>{
            {.name = "cohesive_strength",
             .dimension = units::Dimension::stress,
             .lowest = 1,
             .highest = 1e10,
             .help = "Largest pull between slider and skin, which falls to 0 over an opening of "
                     "twice the work of adhesion over it."},
            &AdhesiveFriction::cohesive_strength}};
  }
  /// Largest tangential traction [Pa]; 0 in tension.
  double limit(const FrictionArguments& at) const;
  /// Derivative of the limit with respect to the normal traction [1].
  double limit_slope(const FrictionArguments& at) const;
  /// Cohesive zone with the given strength and work of adhesion.
  CohesiveZone adhesion() const {
    return {cohesive_strength, 2 * work_of_adhesion / cohesive_strength};
  }
};

} // namespace ionskin::laws
