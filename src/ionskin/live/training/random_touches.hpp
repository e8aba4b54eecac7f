// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/case/slider_motion.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ionskin::live {

/// Range within which random touches stay, as the motion of a case does.
struct TouchRange {
  MotionBox box;           ///< of the slider's centre in contact [m]
  bool is_force = false;   ///< true if a force presses, not a height
  double heaviest = 0;     ///< force of the whole skin [N] or indentation [m]
  double fastest = 0;      ///< in contact [m/s]
  double steepest = 0;     ///< tilt, roll and pitch together [rad]
  double fastest_turn = 0; ///< about z [rad/s]

  bool poses() const { return steepest > 0 || fastest_turn > 0; }
};

/// Throws UserError where the slider never touches.
TouchRange touch_range(const Case& input);

/// Random touches one after the other, as waypoints at whole milliseconds: landing anywhere in the
/// range, strokes, reversals, rests and changes of load at any speed in it, lift-off. Each has a
/// stroke and a rest at least, in any order, so that every event of `touch_events.hpp` is in it
/// where the range has length. The first one goes through the corners of the range under the
/// heaviest load, whatever the seed; where tilts are trained it tilts by the steepest to all four
/// sides at the end, and so does not outgrow the cells later. Angles change on strokes.
Motion random_touches(const TouchRange& range, std::size_t count, std::uint64_t seed);

/// Instants at which the slider begins to come down for each touch of such a motion [s].
std::vector<double> landings(const Motion& motion);

/// A path with rows added at each of the first milliseconds behind every corner in contact: the
/// full model then takes steps that end where a loop steps, while its own would be longer.
Motion with_rows_behind_corners(const Motion& motion);

} // namespace ionskin::live
