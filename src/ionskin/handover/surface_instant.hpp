// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/handover/contact_timeline.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace ionskin::handover {

/// Slider and surface of the skin at one instant. Vectors are normal downwards, along x, along y.
struct SurfaceInstant {
  using Vector = std::array<double, 3>;
  Vector slider{};             ///< place of the slider [m]
  std::vector<Vector> force;   ///< on each cell [N]
  std::vector<Vector> surface; ///< displacement of each cell [m]
  std::vector<Vector> turned;  ///< underside at each cell; empty where the angles never change [m]

  /// Displacement of the slider at a cell since an earlier instant [m].
  Vector moved(const SurfaceInstant& before, std::size_t cell) const;
  /// Displacement of the slider relative to the skin at a cell since an earlier instant: its slip
  /// along x and y [m].
  Vector slip(const SurfaceInstant& before, std::size_t cell) const;
};

/// Areas of the contact cells [m2].
std::vector<double> cell_areas(const mechanics::ContactSolution& contact);

/// Surface of slider and skin in a combination of states.
/// @param areas of the cells [m2]
SurfaceInstant surface_instant(const StateCombination& combination,
                               const std::vector<double>& areas);

} // namespace ionskin::handover
