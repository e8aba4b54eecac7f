// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/poroelasticity/prescribed_load.hpp"
#include "ionskin/poroelasticity/water_walls.hpp"

#include <array>
#include <optional>

namespace ionskin::poroelasticity {

/// Water under pressure outside the walls of the core, docs/model.md (74): computes the steady
/// pore pressure that it causes in the core, linear from wall to wall, and the steady flow through
/// the core. The outside pressures are constant, or follow the waveform of a prescribed load.
class OutsideWater {
public:
  /// @param mobility K of the core [m2/(Pa s)]
  OutsideWater(const Case& input, const WaterWalls& walls, double mobility);

  /// True if the pressure outside at least one wall is not 0.
  bool acts() const { return pressure_[0] != 0 || pressure_[1] != 0; }
  /// Steady pore pressure at a height above the bottom of the core [m] and a time [s] [Pa].
  double steady(double height, double time) const;
  /// Volume of water that the steady flow has carried through the core from bottom to top between
  /// time 0 and `time` [s], per area of the skin [m].
  double passed(double time) const;
  /// Larger magnitude of the two outside pressures [Pa].
  double largest() const;

private:
  std::optional<LoadShares> load_; ///< waveform of the pressures; empty: they are constant
  std::array<double, 2> pressure_; ///< outside the bottom and the top wall [Pa]
  WaterWalls walls_;
  double thickness_, mobility_;
};

} // namespace ionskin::poroelasticity
