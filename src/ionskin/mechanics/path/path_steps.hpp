// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

namespace ionskin::mechanics {

/// A turn by more than this is a new onset of slip [rad].
inline constexpr double sharp_turn = 0.1;

/// Resolution of the steps of the path.
struct PathSteps {
  int touchdown = 20; ///< of a slider that is not flat; one increment is exact for a flat one
  int lift_off = 20;  ///< steps of lift-off and of any other change of load in place
  int onset = 45;
  double onset_growth = 1.06; ///< of successive travel increments
  /// Travel of the onset over the mean tangential displacement that the surface still has to make.
  double onset_travel_ratio = 4;
  /// Contacts solved for a slider on a drive until its motion is given up; 0 for many times what is
  /// expected.
  std::size_t most_driven = 0;
};

} // namespace ionskin::mechanics
