// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/slider_motion.hpp"
#include "ionskin/mechanics/engine/sliding_contact.hpp"

#include <array>
#include <optional>

namespace ionskin::mechanics {

/// Level of the slider along a leg of its motion, a height or a normal force, linear in the
/// fraction of the leg. Also the fractions between which the slider may touch.
struct LegLevels {
  double begin = 0, end = 1;    ///< fractions of the leg between which it may touch [1]
  bool by_force = false;        ///< true if a force presses the slider all along the leg
  double from = 0, to = 0;      ///< at both ends: force on the full skin [N], or height [m]
  std::optional<double> at_end; ///< force at the end of a leg that is led by height [N]
  double meshed_share = 1;      ///< share of a force that the mesh carries, 1 or 0.5 [1]

  /// Level at a fraction of the leg [N] or [m].
  double at(double fraction) const { return fraction == 1 ? to : from + fraction * (to - from); }
  /// Load on the meshed part of the skin at a fraction of the leg.
  SliderLoad load(double fraction) const;
  /// Height of the slider's underside at a fraction of the leg [m]; empty where a force presses it.
  std::optional<double> height(double fraction) const {
    return by_force ? std::nullopt : std::optional(at(fraction));
  }
  bool changes() const { return from != to; }
  /// True if the load increases along the leg.
  bool presses() const { return by_force ? to > from : to < from; }
  /// True if the slider leaves the skin within the leg.
  bool leaves() const { return end < 1; }
};

/// Finds the levels of a leg, given the contact at its begin. Where the leg leads from a height to
/// a force, a trial solution finds the height at which that force is carried.
/// @param place of the slider's centre at the end of the leg, as far as it is known [m]
/// @param meshed_share share of a force that the mesh carries [1]
LegLevels leg_levels(const MotionLeg& leg, const SlidingContact& contact,
                     const std::array<double, 2>& place, double meshed_share);

} // namespace ionskin::mechanics
