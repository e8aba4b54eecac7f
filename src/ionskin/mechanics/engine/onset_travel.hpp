// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/slider_motion.hpp"
#include "ionskin/mechanics/engine/sliding_contact.hpp"
#include "ionskin/mechanics/path/path_steps.hpp"

#include <array>

namespace ionskin::mechanics {

/// Chooses the travel of a slider in its next step. After a landing, a rest or a turn, sliding sets
/// on: while cells still stick, travel grows geometrically, from a small share of the surface's
/// displacement.
class OnsetTravel {
public:
  /// @param half_model true if the mesh covers half of the skin
  OnsetTravel(const PathSteps& steps, bool half_model) : steps_(steps), half_model_(half_model) {}

  /// Notes that the slider rests or is off the skin, so that an onset follows.
  void rest() { direction_ = {}; }
  /// Notes that the slider travels on without an onset, as where it lands while it moves.
  void pass(const std::array<double, 2>& direction);
  /// Begins a leg of travel.
  /// @returns true if an onset of sliding begins
  bool begin(const MotionLeg& leg, const SlidingContact& contact);
  /// Lengthens the next travel after a step.
  /// @param contact after that step
  void grow(const SlidingContact& contact);
  /// True if the onset of sliding along a leg is over: all cells slip, and the surface is within a
  /// hundredth of its displacement in full slip.
  bool is_over(const MotionLeg& leg, const SlidingContact& contact) const;
  double longest() const { return longest_; } ///< of the next step [m]; infinite without an onset

private:
  PathSteps steps_;
  bool half_model_;
  /// Direction of the last travel, a unit vector; 0 after a landing or a rest.
  std::array<double, 2> direction_{};
  double longest_ = 0; ///< travel of the next step [m]
};

} // namespace ionskin::mechanics
