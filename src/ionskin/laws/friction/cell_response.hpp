// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/laws/friction/return_mapping.hpp"

#include <array>
#include <optional>

namespace ionskin::laws {

/// Status of a contact cell; a pulled cell is open, but still attracted by adhesion.
enum class CellStatus { separated, sticking, slipping, pulled };

/// Trial state of a contact cell in a Newton iteration: the forces that would close its gap and
/// stop its slip if the forces on all other cells stayed as they are.
struct CellTrial {
  double area = 0; ///< [m2]
  /// Normal displacement of the cell per normal force on it, other forces fixed [m/N].
  double normal_compliance = 0;
  /// Tangential displacement of the cell per tangential force on it, other forces fixed [m/N].
  double tangential_compliance = 0;
  /// Trial normal force: normal force - opening / normal compliance, compression positive [N].
  double normal = 0;
  /// Trial tangential force: tangential force + slip / tangential compliance [N].
  TangentialVector tangential{};
  double pull = 0;         ///< largest adhesive force, at opening 0 [N]; 0 without adhesion
  double pull_slope = 0;   ///< decrease of the adhesive force per opening [N/m]
  double time_step = 0;    ///< duration of the step [s]
  double lagged_speed = 0; ///< slip speed with the lag of the law, see `FrictionArguments` [m/s]
  ElasticSlip elastic{};   ///< elastic slip at the start of the step
  /// Direction of steady sliding (unit vector), in which the cell then slips whatever the trial;
  /// empty in ordinary steps.
  std::optional<TangentialVector> sliding_direction{};
};

/// Forces on a contact cell by the laws of contact, adhesion and friction, and their derivatives
/// with respect to the trial forces, docs/model.md (4), (6), (42). The surface equations of the
/// contact solver require that these forces equal the cell's forces.
struct CellResponse {
  CellStatus status = CellStatus::separated;
  double normal = 0;          ///< normal force, compression positive [N]
  double normal_by_trial = 0; ///< derivative with respect to the trial normal force [1]
  /// Tangential response, with `traction` as a force [N].
  FrictionResponse tangential;
};
/// Evaluates the laws of contact, adhesion and friction for the trial state of a cell.
CellResponse cell_response(const Friction& friction, const CellTrial& trial);

/// Evaluates the friction law for a cell in contact. In the result `traction` is a force [N].
/// @param normal_force on the cell, compression positive [N]
/// @param slips true to treat the cell as slipping even if the trial force is below the limit
FrictionResponse cell_friction(const Friction& friction, const CellTrial& trial,
                               double normal_force, bool slips = false);

} // namespace ionskin::laws
