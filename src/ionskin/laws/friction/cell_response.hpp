// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/laws/friction/return_mapping.hpp"

#include <array>
#include <optional>

namespace ionskin::laws {

/// Status of a contact cell; pulled is open, but held by adhesion.
enum class CellStatus { separated, sticking, slipping, pulled };

/// State of a contact cell before its forces are known: those that would hold it to the slider, as
/// if its neighbours kept theirs.
struct CellTrial {
  double area = 0;                                     ///< [m2]
  double normal_compliance = 0;                        ///< against its own force [m/N]
  double tangential_compliance = 0;                    ///< likewise [m/N]
  double normal = 0;                                   ///< f - opening / compliance [N]
  TangentialVector tangential{};                       ///< t + slip / compliance [N]
  double pull = 0;                                     ///< of adhesion, at the most [N]
  double pull_slope = 0;                               ///< by how much the opening lowers it [N/m]
  double time_step = 0;                                ///< [s]
  double lagged_speed = 0;                             ///< of slip [m/s]
  ElasticSlip elastic{};                               ///< at the begin of the step
  std::optional<TangentialVector> sliding_direction{}; ///< of the limit of long sliding
};

/// The equations of a contact cell: its forces are those that contact, adhesion and friction allow
/// where trial forces would hold it to the slider, docs/model.md (4), (6), (42).
struct CellResponse {
  CellStatus status = CellStatus::separated;
  double normal = 0;           ///< [N]
  double normal_by_trial = 0;  ///< derivative by the trial normal force [1]
  FrictionResponse tangential; ///< in forces [N]
};
CellResponse cell_response(const Friction& friction, const CellTrial& trial);

/// The tangential force that friction allows a cell that touches, in forces [N].
/// @param slips takes for granted that it does, as `return_mapping`
FrictionResponse cell_friction(const Friction& friction, const CellTrial& trial,
                               double normal_force, bool slips = false);

} // namespace ionskin::laws
