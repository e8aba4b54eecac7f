// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/mechanics/skin/skin_model.hpp"

#include <array>
#include <functional>
#include <span>

namespace ionskin::mechanics {

/// Reach of a contact: how far from the slider's centre cells carry a load.
struct ContactReach {
  /// Farthest edge of a loaded cell from the slider's centre, along x and y [m].
  std::array<double, 2> extent{};
  /// True, along x and along y, if a cell at the border of the footprint is loaded.
  std::array<bool, 2> border{};

  /// Widens the reach by the cells that carry a load.
  /// @param lines cell edges along x and y, from the slider's centre [m]
  /// @param load of each cell, x fastest, in any unit; only every `stride`th value is read
  void include(const std::array<std::span<const double>, 2>& lines, std::span<const double> load,
               std::size_t stride);
  /// Widens the reach to hold another one as well.
  void include(const ContactReach& other);
};

/// Reach of the contact under the heaviest loads of a case, with the slider at a given position: of
/// a touchdown without history, and of steady sliding to and fro along the directions of the path.
/// @param centre of the slider [m]
/// @param friction coefficient [1]
ContactReach hardest_reach(const Case& input, const SkinModel& model,
                           const std::array<double, 2>& centre, double friction);

} // namespace ionskin::mechanics
