// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"

#include <array>

namespace ionskin::mesh {

/// The rectangle under the slider in which the skin may be touched, centred on the slider. Along
/// each direction it ends at a sharp edge of the slider, or the border of the contact lies anywhere
/// in a rim of some width inside it.
struct Footprint {
  std::array<double, 2> half_size{}; ///< along x and y [m]
  std::array<double, 2> rim{};       ///< 0 for a sharp edge, half_size for a round contact [m]

  bool sharp(std::size_t direction) const { return rim[direction] == 0; }
  /// The border may lie anywhere, so all of it is meshed alike.
  bool round(std::size_t direction) const { return rim[direction] >= half_size[direction]; }
};

/// Heaviest load of a cycle; either may be 0.
struct HeaviestLoad {
  double indentation = 0; ///< [m]
  double force = 0;       ///< on the full skin [N]
};
HeaviestLoad heaviest_load(const Case& input);

/// The slider's plan as far as the skin reaches: no contact can be larger.
Footprint footprint_limit(const Case& input);

/// Largest footprint that the slider can have: the plan of a sharp slider; for another one what
/// touches at once and the bound that its shape has for the border around it.
Footprint largest_footprint(const Case& input);

/// True if a footprint along a direction ends where the skin does, not the slider: a contact that
/// reaches its border leaves the skin.
bool ends_at_skin(const Case& input, const Footprint& footprint, std::size_t direction);

/// Estimate of the footprint that a solution will find: the largest but for a round contact under a
/// force, which feels what lies on the softest layer as a plate.
Footprint expected_footprint(const Case& input);

} // namespace ionskin::mesh
