// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/laws/friction/friction_law.hpp"

#include <array>

namespace ionskin::laws {

using TangentialVector = std::array<double, 2>;

/// Elastic slip of one cell between two steps, under a law with an elastic slip: the slip that is
/// given back when the traction goes, and the limit of full slip under which it was made.
struct ElasticSlip {
  TangentialVector slip{}; ///< [m]
  double limit = 0;        ///< [Pa]
};

/// Update of an elastic slip by the slip of a step, docs/model.md (45): `kept` times the first and
/// `taken` times the second. Where the limit rises, what begins to bear is not strained yet, and
/// the traction stays; where it falls, the slip stays, and what lets go takes its share of the
/// traction along. Neither adds to the energy stored. The slip of the step comes while the limit
/// rises, and half of what begins to bear takes it up: no step creates energy:
/// docs/model.md (46), (47).
struct ElasticStep {
  double limit = 0;          ///< of full slip behind the step [Pa]
  double kept = 1;           ///< [1]
  double taken = 1;          ///< [1]
  double kept_by_normal = 0; ///< derivative of `kept` by the normal traction, twice that of `taken`
};

/// Change of the elastic slip and of the limit over a step.
/// @param at its slip increment is of no account
ElasticStep elastic_step(const Friction& friction, const ElasticSlip& before,
                         const FrictionArguments& at);

/// The slip that the limit sees behind a step: that of the step itself, or with what is elastic of
/// it before [m].
TangentialVector slip_of_limit(const Friction& friction, const ElasticSlip& before,
                               const FrictionArguments& at, const TangentialVector& slip);

/// Division of a step's slip: the elastic slip, and the length of the slip that is not given back
/// [m].
struct SlipDivision {
  ElasticSlip elastic;
  double lost = 0;
};
SlipDivision divided_slip(const Friction& friction, const ElasticSlip& before,
                          const FrictionArguments& at, const TangentialVector& slip);

/// Energy that an elastic slip stores [J/m2].
double stored_energy(const Friction& friction, const ElasticSlip& elastic);

} // namespace ionskin::laws
