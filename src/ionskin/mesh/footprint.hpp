// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"

#include <array>

namespace ionskin::mesh {

/// Footprint: rectangle under the slider, centred on the slider, within which the slider may touch
/// the skin. Along each direction the contact either ends at a sharp edge of the slider, or its
/// border lies anywhere in a rim just inside the rectangle.
struct Footprint {
  std::array<double, 2> half_size{}; ///< half sizes along x and y [m]
  /// Width of the rim along x and y [m]: 0 at a sharp edge, `half_size` for a round contact.
  std::array<double, 2> rim{};
  /// Width along x and y that takes as many elements as a rim [m]; 0: that of the rim itself. A
  /// slider that tilts touches a wider rectangle than an upright one, in a contact as small: its
  /// elements are those of the upright slider. At a sharp edge: width whose rim would have the
  /// largest elements further in; 0 under a flat underside, where only the edge ends the contact.
  std::array<double, 2> resolved{};

  /// True if the contact ends at a sharp edge of the slider.
  /// @param direction 0: along x, 1: along y
  bool sharp(std::size_t direction) const { return rim[direction] == 0; }
  /// True if the border of the contact may lie anywhere along a direction (0: x, 1: y), as under a
  /// sphere: all elements of the footprint are then equally large.
  bool round(std::size_t direction) const { return rim[direction] >= half_size[direction]; }
  /// Lets a contact whose border may lie anywhere end at a sharp edge, too.
  void end_sharply(std::size_t direction) {
    if (resolved[direction] == 0) {
      resolved[direction] = rim[direction];
    }
    rim[direction] = 0;
  }
  bool operator==(const Footprint&) const = default;
};

/// Largest indentation and largest normal force that the motion of a case prescribes during a
/// cycle. Either is 0 where the motion prescribes none.
struct HeaviestLoad {
  double indentation = 0; ///< [m]
  double force = 0;       ///< normal, on the full skin [N]
};
HeaviestLoad heaviest_load(const Case& input);
/// Checks that the motion of a case indents the skin or presses on it. Throws UserError otherwise.
void require_load(const Case& input);

/// Largest possible footprint: the plan of the slider. Unless the slider has sharp edges, its plan
/// is cut off shortly before the edges of the skin that it comes nearest to on its track.
Footprint footprint_limit(const Case& input);

/// Upper bound of the footprint of a slider under its heaviest load. It is the plan of a slider
/// with sharp edges; for other shapes it is the flat part, which touches at once, and around it the
/// bound that the shape has for the border of its contact on a half-space of the skin's softest
/// layer.
Footprint largest_footprint(const Case& input);

/// True if a footprint reaches the edge of the skin along a direction (0: x, 1: y) before it
/// reaches the edge of the slider: a contact that fills this footprint leaves the skin.
bool ends_at_skin(const Case& input, const Footprint& footprint, std::size_t direction);

/// True if a footprint whose contact may end anywhere along a direction (0: x, 1: y) reaches the
/// border of the slider's plan: a contact that fills this footprint ends there at a sharp edge, as
/// under a height map that does not rise towards its border. False for a plan at an angle to the
/// skin, whose border no row of cells follows.
bool ends_at_plan(const Case& input, const Footprint& footprint, std::size_t direction);

/// Estimate of the footprint that `mechanics::find_footprint` will find, without a solution of the
/// contact. It equals `largest_footprint`, except for a contact that grows with a given force:
/// there the stiffer layers above the softest one act as a plate, and make the contact smaller.
Footprint expected_footprint(const Case& input);

} // namespace ionskin::mesh
