// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/slider_motion.hpp"
#include "ionskin/mechanics/engine/sliding_contact.hpp"
#include "ionskin/mechanics/path/path_steps.hpp"

#include <array>

namespace ionskin::mechanics {

/// Travel of a slider in its next step: from a small part of the surface's displacement on, growing
/// geometrically, for as long as cells stick after a landing, a rest or a turn.
class OnsetTravel {
public:
  /// @param half_model whether the mesh carries half of the skin
  OnsetTravel(const PathSteps& steps, bool half_model) : steps_(steps), half_model_(half_model) {}

  /// The slider rests, or is off the skin.
  void rest() { direction_ = {}; }
  /// Travels on without an onset, as where it lands on its way.
  void pass(const std::array<double, 2>& direction);
  /// A leg of travel begins. @returns whether an onset of sliding does
  bool begin(const MotionLeg& leg, const SlidingContact& contact);
  /// Takes the step behind which the contact stands.
  void grow(const SlidingContact& contact);
  /// True if the onset is over, along a leg.
  bool is_over(const MotionLeg& leg, const SlidingContact& contact) const;
  double longest() const { return longest_; } ///< travel of the next step [m]

private:
  PathSteps steps_;
  bool half_model_;
  std::array<double, 2> direction_{}; ///< of the last travel; 0 after landing or a rest
  double longest_ = 0;                ///< [m]
};

} // namespace ionskin::mechanics
