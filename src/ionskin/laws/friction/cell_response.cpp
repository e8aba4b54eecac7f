// SPDX-License-Identifier: Apache-2.0
#include "ionskin/laws/friction/cell_response.hpp"

#include <cmath>

namespace ionskin::laws {
namespace {

/// Friction of a cell in steady sliding: it slips along the given direction, whatever its trial
/// force.
FrictionResponse sliding_friction(const Friction& friction, const CellTrial& trial,
                                  double normal_force) {
  const FrictionArguments at{normal_force / trial.area, 0, trial.time_step, trial.lagged_speed};
  FrictionResponse response;
  response.traction =
      sliding_traction(friction, trial.area * friction.limit(at), *trial.sliding_direction);
  response.by_normal =
      sliding_traction(friction, friction.limit_slope(at), *trial.sliding_direction);
  return response;
}

} // namespace

FrictionResponse cell_friction(const Friction& friction, const CellTrial& trial,
                               double normal_force, bool slips) {
  if (trial.sliding_direction) {
    return sliding_friction(friction, trial, normal_force);
  }
  FrictionResponse response =
      return_mapping(friction,
                     {normal_force / trial.area,
                      {trial.tangential[0] / trial.area, trial.tangential[1] / trial.area},
                      trial.tangential_compliance * trial.area,
                      trial.time_step,
                      trial.lagged_speed,
                      trial.elastic},
                     slips);
  for (double& component : response.traction) {
    component *= trial.area;
  }
  return response;
}

CellResponse cell_response(const Friction& friction, const CellTrial& trial) {
  CellResponse response;
  if (trial.normal > -trial.pull || std::isnan(trial.normal)) {
    response.normal = trial.normal;
    response.normal_by_trial = 1;
    response.tangential = cell_friction(friction, trial, trial.normal);
    response.status = response.tangential.sticks ? CellStatus::sticking : CellStatus::slipping;
    return response;
  }
  const double softening = trial.pull_slope * trial.normal_compliance;
  // Adhesion ends at its range, and with a softening of 1 or more no opening balances it.
  if (trial.pull == 0 || softening >= 1 || softening * trial.normal <= -trial.pull) {
    return response;
  }
  response.status = CellStatus::pulled;
  response.normal = -(trial.pull + softening * trial.normal) / (1 - softening);
  response.normal_by_trial = -softening / (1 - softening);
  return response;
}

} // namespace ionskin::laws
