// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/slider_motion.hpp"
#include "ionskin/mechanics/engine/sliding_contact.hpp"

#include <array>
#include <optional>

namespace ionskin::mechanics {

/// Level that presses a slider along a leg, and the fractions of the leg between which it may
/// touch.
struct LegLevels {
  double begin = 0, end = 1;
  bool by_force = false;   ///< all along
  double from = 0, to = 0; ///< force of the whole skin [N], or height at the ends of the leg [m]
  std::optional<double> at_end; ///< force that the leg ends with though it goes by height [N]
  double meshed_share = 1;      ///< part of a force that the mesh carries

  double at(double fraction) const { return fraction == 1 ? to : from + fraction * (to - from); }
  SliderLoad load(double fraction) const;
  /// Height of the slider; empty where a force presses it [m].
  std::optional<double> height(double fraction) const {
    return by_force ? std::nullopt : std::optional(at(fraction));
  }
  bool changes() const { return from != to; }
  bool presses() const { return by_force ? to > from : to < from; } ///< harder and harder
  /// True if the slider leaves on the way.
  bool leaves() const { return end < 1; }
};

/// Levels of the load on a leg that the contact is about to take.
/// @param place of the slider at the end, as far as it is known [m]
LegLevels leg_levels(const MotionLeg& leg, const SlidingContact& contact,
                     const std::array<double, 2>& place, double meshed_share);

} // namespace ionskin::mechanics
