// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/laws/friction/elastic_slip.hpp"
#include "ionskin/laws/friction/friction_law.hpp"

#include <array>

namespace ionskin::laws {

/// Result of the return mapping of friction: the tangential traction that the law allows when the
/// trial traction would make the cell stick, and its derivatives (as in plasticity, Simo and
/// Laursen 1992, doi 10.1016/0045-7949(92)90540-G). The slip of the cell is
/// `FrictionTrial::compliance` * (trial traction - traction), docs/model.md (6), (7).
struct FrictionResponse {
  bool sticks = false;
  TangentialVector traction{}; ///< along x and y [Pa]
  /// Derivatives [r][s] of component r of the traction with respect to component s of the trial
  /// traction [1].
  std::array<TangentialVector, 2> by_trial{};
  TangentialVector by_normal{}; ///< derivatives with respect to the normal traction [1]
};

/// Trial state of a contact cell, before its slip in the step is known.
struct FrictionTrial {
  double normal_traction = 0;  ///< compression positive [Pa]
  TangentialVector traction{}; ///< tangential traction that would make the cell stick [Pa]
  double compliance = 0;       ///< slip over (trial traction - traction) [m/Pa]
  double time_step = 0;        ///< duration of the step [s]
  double lagged_speed = 0;     ///< slip speed with the lag of the law [m/s]
  ElasticSlip elastic{};       ///< elastic slip at the start of the step
};

/// Computes the tangential traction of a cell at the end of a step, and its derivatives, by return
/// mapping, docs/model.md (6), (7).
/// @param slips true to treat the cell as slipping: the traction is scaled to the limit even if the
///   trial traction is shorter
FrictionResponse return_mapping(const Friction& friction, const FrictionTrial& trial,
                                bool slips = false);

/// Norm of a tangential traction in which the friction limit has the same length in all directions,
/// its length along x [Pa]: sqrt(t_x^2 + (t_y / across)^2).
double limit_norm(const Friction& friction, const TangentialVector& traction);

/// Tangential traction of a cell that slides along a given direction; zero for a zero direction.
/// @param limit friction limit along x, as a traction or a force; the result has its unit
/// @param direction unit vector of the slip of the slider over the skin
TangentialVector sliding_traction(const Friction& friction, double limit,
                                  const TangentialVector& direction);

} // namespace ionskin::laws
