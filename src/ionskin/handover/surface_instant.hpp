// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/handover/contact_timeline.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace ionskin::handover {

/// Position of the slider, and forces on and displacement of the skin's top face, at one instant.
/// Vectors have the components normal (downwards), along x, along y. Cells are numbered x fastest.
struct SurfaceInstant {
  using Vector = std::array<double, 3>;
  Vector slider{};             ///< position of the slider [m]
  std::vector<Vector> force;   ///< force on each cell [N]
  std::vector<Vector> surface; ///< mean displacement of each cell of the skin [m]
  /// Position of the underside at each cell by the rotation of the slider; empty where its angles
  /// never change [m].
  std::vector<Vector> turned;

  /// Calculates the displacement of the slider's underside at a cell since an earlier instant [m].
  Vector moved(const SurfaceInstant& before, std::size_t cell) const;
  /// Calculates the slip at a cell since an earlier instant: the displacement of the slider's
  /// underside minus that of the skin [m]. The components along x and y are the slip of friction.
  Vector slip(const SurfaceInstant& before, std::size_t cell) const;
};

/// Calculates the areas of the contact cells, x fastest [m2].
std::vector<double> cell_areas(const mechanics::ContactSolution& contact);

/// Evaluates the slider and the top face of the skin for a combination of contact states.
/// @param areas of the cells, from `cell_areas` [m2]
SurfaceInstant surface_instant(const StateCombination& combination,
                               const std::vector<double>& areas);

} // namespace ionskin::handover
