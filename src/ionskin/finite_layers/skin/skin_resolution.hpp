// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/finite_layers/faces/free_sides.hpp"
#include "ionskin/finite_layers/faces/thickness_column.hpp"
#include "ionskin/finite_layers/plane/wave_split.hpp"

#include <vector>

namespace ionskin::finite_layers {

/// Distances of the loaded part of the top face from the ends and from the sides of the skin [m].
struct Clearance {
  double ends = 0, sides = 0;
};

/// Purpose for which a skin is resolved. `results` is for reported quantities; `outline` finds only
/// the border of the contact, to some percent.
enum class SkinPurpose { results, outline };

/// Resolution of a skin, made by `skin_resolution`. With `SkinPurpose::results`, doubling any of
/// its numbers changes forces and strains by less than the tolerance.
struct SkinResolution {
  double split_tolerance = 0; ///< relative size at which either share of the waves is neglected [1]
  double reach = 0;           ///< distance at which short waves end [m]
  /// Wave number along a free face up to which waves count in full, times the reach of the face
  /// [1].
  double face_waves = 0;
  /// Distance over which the motions of the ends and of the sides are felt, not below `reach`: they
  /// have no shorter waves under loads that are as far away [m].
  double ends_reach = 0, sides_reach = 0;
  /// Number up to which modes across the skin are summed singly.
  int one_by_one = 0;
  int degree = 0;                     ///< polynomial degree of the elements through the thickness
  std::vector<ElementSizes> elements; ///< elements through each layer, bottom to top

  bool operator==(const SkinResolution&) const = default;
  /// Split of the compliance into short and long waves.
  WaveSplit split() const { return {reach, split_tolerance}; }
  /// Calculates the resolution of a free face.
  /// @param face_reach distance over which its motion is felt [m]
  /// @param length of the skin along the face [m]
  FaceResolution face(double face_reach, double length) const;
};

/// Chooses the resolution of a skin. Short waves reach twice the smaller clearance, which is the
/// distance from the slider to its nearest mirror image, but at least 0.75 and at most 2.5
/// thicknesses of the skin; on a skin that is very wide for its thickness, at most a 32nd of the
/// root of its area. Where a face is nearer than half the reach, its effect on the shorter waves is
/// neglected. The motion of a face is resolved for its own clearance, rounded down to half a power
/// of 2 of the reach, so that skins of similar paths are the same.
/// @param clearance smallest distances over the whole path of the slider
SkinResolution skin_resolution(const Skin& skin, const Clearance& clearance,
                               SkinPurpose purpose = SkinPurpose::results);

} // namespace ionskin::finite_layers
