// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/handover/skin_deformation.hpp"

#include <array>
#include <vector>

namespace ionskin::results {

/// The whole skin and the slider on it at one instant.
struct SkinSnapshot {
  double time = 0; ///< since the begin of the run [s]
  handover::SkinDeformation skin;
  std::array<double, 2> centre{};     ///< of the slider from the skin's corner [m]
  double height = 0;                  ///< of its lowest point above the undeformed top face [m]
  std::vector<double> cell_x, cell_y; ///< lines between the cells of the contact [m]
  /// Traction of the slider on each cell, along x, y and upwards, [y][x], x fastest [Pa].
  std::array<std::vector<double>, 3> traction;
  /// Mean displacement of each cell, along x, y and upwards [m].
  std::array<std::vector<double>, 3> surface;
};

} // namespace ionskin::results
