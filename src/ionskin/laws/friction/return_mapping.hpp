// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/laws/friction/elastic_slip.hpp"
#include "ionskin/laws/friction/friction_law.hpp"

#include <array>

namespace ionskin::laws {

/// The traction that a law allows where a trial traction would hold the surface to the slider: the
/// surface gives way by `compliance` times the difference of both, and that is the slip. In the
/// way of return mappings in plasticity (Simo and Laursen 1992, doi 10.1016/0045-7949(92)90540-G).
struct FrictionResponse {
  bool sticks = false;
  TangentialVector traction{};                ///< [Pa]
  std::array<TangentialVector, 2> by_trial{}; ///< derivative of component r by that of the trial s
  TangentialVector by_normal{};               ///< derivative by the normal traction
};

/// State of a cell before its slip is known.
struct FrictionTrial {
  double normal_traction = 0;  ///< [Pa]
  TangentialVector traction{}; ///< [Pa]
  double compliance = 0;       ///< slip over the traction that is not carried [m/Pa]
  double time_step = 0;        ///< [s]
  double lagged_speed = 0;     ///< [m/s]
  ElasticSlip elastic{};       ///< at the begin of the step
};

/// Traction of a cell behind a step, with its derivatives.
/// @param slips takes for granted that the cell slips: its traction is at the limit, to where it is
/// lengthened if need be
FrictionResponse return_mapping(const Friction& friction, const FrictionTrial& trial,
                                bool slips = false);

/// Length of a traction in a norm in which the limits of all directions are the one along x.
double limit_norm(const Friction& friction, const TangentialVector& traction);

/// Traction of a limit against sliding along a direction of length 1.
TangentialVector sliding_traction(const Friction& friction, double limit,
                                  const TangentialVector& direction);

} // namespace ionskin::laws
