// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/poroelasticity/prescribed_load.hpp"
#include "ionskin/poroelasticity/water_walls.hpp"

#include <array>
#include <optional>

namespace ionskin::poroelasticity {

/// Water outside the walls, docs/model.md (74): the pressure in the core that would stand still
/// under it, linear from wall to wall, and what flows through meanwhile. Constant from the first
/// instant on, or over time as a prescribed load.
class OutsideWater {
public:
  /// @param mobility of the core [m2/(Pa s)]
  OutsideWater(const Case& input, const WaterWalls& walls, double mobility);

  /// True if there is any water under pressure outside.
  bool acts() const { return pressure_[0] != 0 || pressure_[1] != 0; }
  /// Steady pressure at a height in the core [Pa].
  double steady(double height, double time) const;
  /// Water that has gone through the core from bottom to top since the first instant, per area [m].
  double passed(double time) const;
  /// Largest magnitude of a pressure [Pa].
  double largest() const;

private:
  std::optional<LoadShares>
      load_; ///< shares that the pressures follow; without them they are constant
  std::array<double, 2> pressure_; ///< outside the bottom and the top wall [Pa]
  WaterWalls walls_;
  double thickness_, mobility_;
};

} // namespace ionskin::poroelasticity
