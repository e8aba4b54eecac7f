// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/mechanics/contact_plan.hpp"
#include "ionskin/mechanics/friction_law.hpp"
#include "ionskin/mechanics/skin_model.hpp"
#include "ionskin/mechanics/solve_contact.hpp"
#include "ionskin/mechanics/solved_pieces.hpp"

#include <mutex>
#include <vector>

namespace ionskin::mechanics {

/// Reports progress from several threads, one at a time. How many positions there will be is known
/// only in the end.
class SharedProgress {
public:
  SharedProgress(const base::ProgressCallback& callback, std::size_t expected_units)
      : callback_(callback), expected_(expected_units) {}
  void add_units(std::size_t units) {
    const std::lock_guard lock(mutex_);
    known_ += units;
  }
  void finish_unit() {
    const std::lock_guard lock(mutex_);
    const double part =
        static_cast<double>(++finished_) / static_cast<double>(std::max(known_, expected_));
    reported_ = std::max(reported_, part);
    callback_("mechanics", reported_);
  }

private:
  const base::ProgressCallback& callback_;
  std::size_t expected_, known_ = 0, finished_ = 0;
  double reported_ = 0;
  std::mutex mutex_;
};

/// One friction coefficient. It gets the nodes that it needs itself, so that its solution does not
/// depend on what is solved beside it.
struct FrictionSolve {
  double friction = 0;
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
  const FrictionLaw* law = nullptr;
};

/// Solves what is open of all friction coefficients: each position is factorised once for all of
/// them, side by side.
void solve_open_positions(const SharedSetting& setting, std::vector<FrictionSolve>& solves);

} // namespace ionskin::mechanics
