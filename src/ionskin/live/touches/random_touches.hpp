// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/case/slider_motion.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ionskin::live {

/// Range of positions, loads, speeds and poses of the random touches, taken from the motion of a
/// case.
struct TouchRange {
  MotionBox box;           ///< rectangle of the slider's centre in contact [m]
  bool is_force = false;   ///< true if a force presses the slider, false if a height is held
  double heaviest = 0;     ///< largest force on the whole skin [N] or indentation [m]
  double fastest = 0;      ///< largest speed along the skin in contact [m/s]
  double steepest = 0;     ///< largest tilt, roll and pitch together [rad]
  double fastest_turn = 0; ///< fastest rotation about z [rad/s]
  /// True if a touch begins at any yaw, since the slider turns and does not look alike from all
  /// sides.
  bool any_yaw = false;

  /// True if the slider tilts or rotates about z.
  bool poses() const { return steepest > 0 || fastest_turn > 0; }
};

/// Generates a motion of random touches, one after the other, as waypoints at whole milliseconds:
/// landing anywhere in the range, strokes, reversals, rests and changes of load at any speed in it,
/// lift-off. Landings, lift-offs and load steps last from a millisecond on. Each touch has at least
/// one stroke, and one rest with a load step in it, so that it contains every event of
/// `touch_events.hpp` if the range has length and the load step is not small. The first touch is
/// the same for all seeds: it goes through the corners of the range under the heaviest load, and
/// ends with the steepest tilts to all four sides where tilts are trained and with a full turn
/// where a touch may begin at any yaw, so that no later touch outgrows the contact cells. Angles
/// change during strokes.
Motion random_touches(const TouchRange& range, std::size_t count, std::uint64_t seed);

/// Generates the motion of a single touch, drawn as those of `random_touches` behind the first: the
/// slider waits above the place where it lands, and ends with such a wait.
Motion random_touch(const TouchRange& range, std::uint64_t seed);

/// Instants at which the slider begins to come down, one for each touch of such a motion [s].
std::vector<double> landings(const Motion& motion);

/// Adds waypoints at each of the first 50 milliseconds after every corner in contact, without
/// changing the path. The full model then takes steps that end where a real-time loop steps; its
/// own would be longer.
Motion with_rows_behind_corners(const Motion& motion);

} // namespace ionskin::live
