// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/handover/skin_deformation.hpp"

#include <array>
#include <vector>

namespace ionskin::results {

/// Deformation of the whole skin, and position and tractions of one slider on it, at one instant.
/// Made by `study::skin_snapshot` for `write_skin`.
struct SkinSnapshot {
  double time = 0;                ///< since the start of the run [s]
  handover::SkinDeformation skin; ///< displacement and stress of all layers
  std::array<double, 2> centre{}; ///< x and y of the slider's centre from the skin's corner [m]
  /// Height of the slider's lowest point above the undeformed top face [m]; negative when pressed
  /// in.
  double height = 0;
  /// Edges of the contact cells along x and y, from the skin's corner [m].
  std::vector<double> cell_x, cell_y;
  /// Traction of the slider on each contact cell: components along x, y and upwards, each [y][x]
  /// [Pa].
  std::array<std::vector<double>, 3> traction;
  /// Mean displacement of the top face over each contact cell: components along x, y and upwards,
  /// each [y][x] [m].
  std::array<std::vector<double>, 3> surface;
};

} // namespace ionskin::results
