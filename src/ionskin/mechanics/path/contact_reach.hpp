// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/mechanics/skin/skin_model.hpp"

#include <array>
#include <functional>
#include <span>

namespace ionskin::mechanics {

/// Distance from the slider's centre at which any cell carries a normal load, along x and y, and
/// whether cells at the border do.
struct ContactReach {
  std::array<double, 2> extent{}; ///< [m]
  std::array<bool, 2> border{};

  /// Widens the reach by the cells that carry a load.
  /// @param lines edges of the cells along x and y, from the slider's centre [m]
  /// @param load of each cell, x fastest, of any unit; every `stride`th value
  void include(const std::array<std::span<const double>, 2>& lines, std::span<const double> load,
               std::size_t stride);
  void include(const ContactReach& other);
};

/// Reach of the loads that press hardest, with the slider at a place: touchdown without history,
/// and steady sliding to and fro along the directions of the path.
ContactReach hardest_reach(const Case& input, const SkinModel& model,
                           const std::array<double, 2>& centre, double friction);

} // namespace ionskin::mechanics
