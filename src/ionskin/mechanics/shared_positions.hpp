// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/mechanics/path/contact_plan.hpp"
#include "ionskin/mechanics/path/shared_progress.hpp"
#include "ionskin/mechanics/path/solved_pieces.hpp"
#include "ionskin/mechanics/position/skin_model.hpp"
#include "ionskin/mechanics/solve_contact.hpp"

#include <vector>

namespace ionskin::mechanics {

/// One variant. It gets the nodes that it needs itself, so that its solution does not
/// depend on what is solved beside it.
struct FrictionSolve {
  double friction = 0;
  PathSteps steps;
  ContactPlan plan;
  std::vector<PositionTask> open; ///< of the plan, not solved yet
  SolvedPieces pieces;
};

/// What all solves on one mesh share.
struct SharedSetting {
  const SkinModel& model;
  const ContactOptions& options;
  base::Timers& timers;
  SharedProgress& progress;
  const Contact& contact; ///< its coefficient is that of each solve
};

/// Solves what is open of all friction coefficients: each position is factorised once for all of
/// them, side by side.
void solve_open_positions(const SharedSetting& setting, std::vector<FrictionSolve>& solves);

} // namespace ionskin::mechanics
