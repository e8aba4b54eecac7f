// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/mechanics/output/contact_solution.hpp"

#include <array>
#include <vector>

namespace ionskin::mechanics {

/// Forces of a slider on its contact cells along its path. Forces and position are linear in time
/// between instants.
struct ForcePath {
  struct Instant {
    double time = 0;                ///< since the begin of the cycle [s]
    std::array<double, 2> centre{}; ///< centre of the slider [m]
    std::vector<double> force;      ///< per contact cell: normal (downwards), x, y [N]
  };
  std::vector<double> lines_x, lines_y; ///< edges of the contact cells from the slider's centre [m]
  std::vector<Instant> instants;        ///< in ascending time
  bool half = false; ///< true if cells cover only y < 0, and mirror images carry mirrored forces

  /// Interpolates forces and position at a time since the begin of the cycle [s], clamped to the
  /// path.
  Instant at(double time) const;
};

/// Extracts the forces on the contact cells along the path of a solution; 0 while the slider is off
/// the skin.
ForcePath force_path(const ContactSolution& solution);

/// Relative difference between two force paths of one slider [1]: the largest difference at an
/// instant of `now`, over the largest force, each as a sum of magnitudes over the cells. Infinite
/// where the cells differ.
double change_of_forces(const ForcePath& now, const ForcePath& before);

/// Distance between two rectangles with sides along x and y; 0 where they overlap [m].
/// @param centre,other_centre their centres [m]
/// @param half_size,other_half_size their half sizes along x and y [m]
double distance(const std::array<double, 2>& centre, const std::array<double, 2>& half_size,
                const std::array<double, 2>& other_centre,
                const std::array<double, 2>& other_half_size);

} // namespace ionskin::mechanics
