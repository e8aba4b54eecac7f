// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/mechanics/engine/motion_stepper.hpp"
#include "ionskin/mechanics/engine/path_thinning.hpp"
#include "ionskin/mechanics/engine/stepped_strains.hpp"

#include <memory>
#include <vector>

namespace ionskin::mechanics {

/// Path that a solution stores: the instants that `PathThinning` leaves of all steps, with their
/// states, written into a `ContactSolution`.
class KeptPath {
public:
  /// @param model,solution must outlive this object
  /// @param strains receives the forces of each stored state, and recovers its strain
  KeptPath(const SkinModel& model, std::shared_ptr<SteppedStrains> strains,
           const ThinningTolerance& tolerance, ContactSolution& solution);

  /// Adds the state of the contact at an instant.
  void add(const StepPoint& point, const SlidingContact& contact);
  void finish() { thinning_.finish(); }

private:
  static double unresisted_depth(const StepPoint& point, const SlidingContact& contact);
  void keep(PathThinning::Instant&& instant);

  const SkinModel& model_;
  std::shared_ptr<SteppedStrains> strains_;
  ContactSolution& solution_;
  PathThinning thinning_;
  std::vector<double> total_slip_;
  double largest_force_ = 0, largest_indentation_ = 0, last_time_ = -1;
};

} // namespace ionskin::mechanics
