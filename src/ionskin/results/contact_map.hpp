// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace ionskin::results {

/// Tractions of one contact state per face cell, [y][x] with x fastest.
struct ContactMap {
  /// Such as "touchdown", "onset_07", "steady_4", "lift_off_12"; of a second slide "2_steady_4".
  std::string state;
  double parameter = 0; ///< instant of the first cycle at which it is passed [s]
  std::vector<double> pressure, shear_x, shear_y; ///< [Pa]
  /// Slip since the state before [m].
  std::vector<double> slip;
  std::vector<double> slip_state; ///< 0 detached, 1 sticks, 3 slips, as readout::SlipState
  /// Length of the way that the slider slipped over each cell since it touches [m].
  std::vector<double> slip_since_landing;
};

/// The contact states of a run.
struct ContactMaps {
  std::vector<double> cell_lines_x, cell_lines_y; ///< cell edges from the slider's centre [m]
  std::vector<ContactMap> maps;
};

} // namespace ionskin::results
