// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/mechanics/output/contact_solution.hpp"

#include <array>
#include <vector>

namespace ionskin::mechanics {

/// Forces of a slider on its cells along its path, between whose instants all is linear.
struct ForcePath {
  struct Instant {
    double time = 0;                ///< since the begin of the cycle [s]
    std::array<double, 2> centre{}; ///< of the slider [m]
    std::vector<double> force;      ///< per cell normal (downwards), x, y [N]
  };
  std::vector<double> lines_x, lines_y; ///< cell edges from its centre [m]
  std::vector<Instant> instants;        ///< ascending
  bool half = false; ///< cells of y < 0 alone: mirror images carry the mirrored forces

  Instant at(double time) const;
};

/// Forces on the cells along the path of a solution.
ForcePath force_path(const ContactSolution& solution);

/// Largest difference of the forces at the instants of `now` from those of another path on the same
/// cells, over the largest force, both as sums over the cells; infinite on other cells [1].
double change_of_forces(const ForcePath& now, const ForcePath& before);

/// Distance of two rectangles whose sides are parallel; 0 where they meet [m].
double distance(const std::array<double, 2>& centre, const std::array<double, 2>& half_size,
                const std::array<double, 2>& other_centre,
                const std::array<double, 2>& other_half_size);

} // namespace ionskin::mechanics
