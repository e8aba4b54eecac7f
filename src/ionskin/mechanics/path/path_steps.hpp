// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

namespace ionskin::mechanics {

/// Change of the direction of travel above which a new onset of sliding begins [rad].
inline constexpr double sharp_turn = 0.1;

/// Numbers of contact steps into which the parts of a path are divided.
struct PathSteps {
  /// Steps of a touchdown to the heaviest load. A flat slider takes a single step, which is exact.
  int touchdown = 20;
  int lift_off = 20;          ///< steps of a lift-off, and of other decreases of the load
  int onset = 45;             ///< steps of an onset of sliding, from stick to full slip
  double onset_growth = 1.06; ///< ratio of successive travel increments in an onset [1]
  /// Travel of all steps of an onset, over the mean tangential displacement that the surface still
  /// has to make until full slip [1].
  double onset_travel_ratio = 4;
  /// Largest number of contact solutions for a slider on a drive before its motion is given up; 0:
  /// many times the expected number.
  std::size_t most_driven = 0;
};

} // namespace ionskin::mechanics
