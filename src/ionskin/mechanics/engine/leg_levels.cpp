// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/engine/leg_levels.hpp"

namespace ionskin::mechanics {

SliderLoad LegLevels::load(double fraction) const {
  if (by_force) {
    return {LoadKind::force, at(fraction) * meshed_share};
  }
  if (fraction == 1 && at_end) {
    return {LoadKind::force, *at_end * meshed_share};
  }
  // Rounding must not leave an indentation where the slider leaves the skin.
  return {LoadKind::indentation, fraction == end && leaves() ? 0.0 : -at(fraction)};
}

LegLevels leg_levels(const MotionLeg& leg, const SlidingContact& contact,
                     const std::array<double, 2>& place, double meshed_share) {
  LegLevels levels;
  levels.meshed_share = meshed_share;
  levels.by_force = leg.from_level.is_force && leg.to_level.is_force;
  if (levels.by_force) {
    levels.from = leg.from_level.value;
    levels.to = leg.to_level.value;
    return levels;
  }
  const double range = contact.range();
  const double off = contact.in_contact() ? -contact.state().indentation : range;
  levels.from = leg.from_level.is_force ? off : leg.from_level.value;
  levels.to = leg.to_level.value;
  if (leg.to_level.is_force) {
    // Finds the height at which the force will be carried, on a copy of the contact.
    SlidingContact trial = contact;
    trial.set_end_of_step(leg.end());
    levels.at_end = leg.to_level.value;
    levels.to = -trial
                     .step(leg.duration, place,
                           {LoadKind::force, leg.to_level.value * meshed_share}, leg.to_pose)
                     .indentation;
  }
  const bool adheres = range > 0;
  if (levels.from > range && !(adheres && contact.in_contact())) {
    levels.begin = (levels.from - range) / (levels.from - levels.to);
  }
  if (levels.to > 0 && !adheres) {
    levels.end = levels.from / (levels.from - levels.to);
  }
  return levels;
}

} // namespace ionskin::mechanics
