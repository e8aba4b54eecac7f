// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"

#include <limits>

namespace ionskin::poroelasticity {

inline constexpr double sealed_wall = 0;
inline constexpr double open_wall = std::numeric_limits<double>::infinity();

/// Permeability of the walls of the core to water: conductance of each wall over the mobility of
/// the core, G/K [1/m]; `sealed_wall` (0) or `open_wall` (infinity) at the extremes.
struct WaterWalls {
  double bottom = sealed_wall, top = sealed_wall;

  /// Steady pore pressure at a height, for a unit pressure outside the top wall and zero outside
  /// the bottom wall, docs/model.md (74) [1].
  /// @param height above the bottom of the core [m]
  /// @param thickness of the core [m]
  double share_of_top(double height, double thickness) const;
  /// Derivative of `share_of_top` with respect to height [1/m]; 0 beside a sealed wall.
  double slope_of_share(double thickness) const;
};

/// Derives the permeability of both walls from the keys of a case.
/// @param mobility K of the core [m2/(Pa s)]
WaterWalls water_walls(const Water& water, double mobility);

} // namespace ionskin::poroelasticity
