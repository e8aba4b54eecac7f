// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/laws/friction/friction_law.hpp"

#include <array>

namespace ionskin::laws {

using TangentialVector = std::array<double, 2>;

/// State variable of a contact cell under a friction law with elastic slip: the part of the slip
/// that springs back when the traction vanishes, and the friction limit at the end of the step that
/// made it.
struct ElasticSlip {
  TangentialVector slip{}; ///< elastic slip along x and y [m]
  double limit = 0;        ///< traction limit in full slip, mu p [Pa]
};

/// Coefficients that update the elastic slip over one step, docs/model.md (45):
///   elastic slip after = `kept` * elastic slip before + `taken` * slip of the step,
/// cut to the length `Friction::elastic_slip`. The tangential stiffness is the limit over that
/// length, so it changes with pressure. Where the limit rises, newly loaded contact is unstrained
/// and the traction is kept; where it falls, the elastic slip is kept and the released contact
/// loses its share of the traction. The mean of both stiffnesses resists the slip of the step. So
/// no step creates energy: docs/model.md (46), (47).
struct ElasticStep {
  double limit = 0; ///< traction limit in full slip at the end of the step [Pa]
  double kept = 1;  ///< factor of the elastic slip before the step [1]
  double taken = 1; ///< factor of the slip of the step [1]
  /// Derivative of `kept` with respect to the normal traction, twice the derivative of `taken`
  /// [1/Pa].
  double kept_by_normal = 0;
};

/// Computes the update coefficients of the elastic slip for one step.
/// @param before elastic slip at the start of the step
/// @param at arguments at the end of the step; the slip increment is ignored
ElasticStep elastic_step(const Friction& friction, const ElasticSlip& before,
                         const FrictionArguments& at);

/// Slip on which the friction limit depends at the end of a step [m]: the slip of the step, or
/// under a law with elastic slip the updated elastic slip before it is cut to
/// `Friction::elastic_slip`.
/// @param slip of the step, along x and y [m]
TangentialVector slip_of_limit(const Friction& friction, const ElasticSlip& before,
                               const FrictionArguments& at, const TangentialVector& slip);

/// Slip of a step, divided into an elastic and an irreversible part.
struct SlipDivision {
  ElasticSlip elastic; ///< elastic slip after the step; 0 without compression
  double lost = 0;     ///< length of the irreversible slip of the step [m]
};
/// Divides the slip of a step into its elastic and its irreversible part.
/// @param before elastic slip at the start of the step
/// @param slip of the step, along x and y [m]
SlipDivision divided_slip(const Friction& friction, const ElasticSlip& before,
                          const FrictionArguments& at, const TangentialVector& slip);

/// Energy per area stored in an elastic slip [J/m2].
double stored_energy(const Friction& friction, const ElasticSlip& elastic);

} // namespace ionskin::laws
