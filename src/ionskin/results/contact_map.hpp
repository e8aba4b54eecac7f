// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace ionskin::results {

/// Tractions and slip of the contact cells in one state on the slider's path: one value per contact
/// cell, [y][x] with x fastest.
struct ContactMap {
  /// Name of the state: "touchdown_03", "onset_07", "steady_4" or "lift_off_12", numbered in order;
  /// "2_steady_4" in the second slide.
  std::string state;
  double time = 0; ///< time in the first cycle at which the slider passes the state [s]
  /// Normal traction (compression positive) and tangential tractions of the slider on the skin
  /// [Pa].
  std::vector<double> pressure, shear_x, shear_y;
  /// Length of the slip since the preceding state on the path [m].
  std::vector<double> slip;
  std::vector<double> slip_state; ///< 0 detached, 1 sticks, 3 slips, as `readout::SlipState` [1]
  /// Length of the path that the slider has slipped over each cell since the cell came into contact
  /// [m]; 0 where it does not touch.
  std::vector<double> slip_since_landing;
};

/// Contact maps of one slider for all stored states of a run, on one grid of contact cells.
struct ContactMaps {
  /// Edges of the contact cells, measured from the slider's centre [m].
  std::vector<double> cell_lines_x, cell_lines_y;
  std::vector<ContactMap> maps; ///< in order of time
};

} // namespace ionskin::results
