// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"

#include <limits>

namespace ionskin::poroelasticity {

inline constexpr double sealed_wall = 0;
inline constexpr double open_wall = std::numeric_limits<double>::infinity();

/// Conductance of the walls of the core, over the mobility of the core [1/m].
struct WaterWalls {
  double bottom = sealed_wall, top = sealed_wall;

  /// Steady pressure in the core under one unit outside the top wall and none outside the bottom
  /// one, docs/model.md (74). The core ends at 0 and at `thickness` [m].
  double share_of_top(double height, double thickness) const;
  /// Slope of the share [1/m].
  double slope_of_share(double thickness) const;
};

/// Conductances of both walls over the mobility of the core [1/m], from the keys of a case.
/// @param mobility of the core [m2/(Pa s)]
WaterWalls water_walls(const Water& water, double mobility);

} // namespace ionskin::poroelasticity
