// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/finite_layers/faces/free_sides.hpp"
#include "ionskin/finite_layers/faces/thickness_column.hpp"
#include "ionskin/finite_layers/plane/wave_split.hpp"

#include <vector>

namespace ionskin::finite_layers {

/// Clearance of the loaded part of the face from the ends and from the sides of the skin [m].
struct Clearance {
  double ends = 0, sides = 0;
};

/// Purpose for which a skin is resolved: results, or only where on it a contact ends, to some
/// percent.
enum class SkinPurpose { results, outline };

/// Resolution of the skin. For results each number doubled changes forces and strains by less than
/// the tolerance.
struct SkinResolution {
  double split_tolerance = 0; ///< of either share of the waves where it is left out [1]
  double reach = 0;           ///< of short waves [m]
  /// Wave number up to which waves along a free face count in full, over 1/reach [1].
  double face_waves = 0;
  int one_by_one = 0;                 ///< modes across the skin that are summed by themselves
  int degree = 0;                     ///< of the elements through the thickness
  std::vector<ElementSizes> elements; ///< of each layer

  bool operator==(const SkinResolution&) const = default;
  WaveSplit split() const { return {reach, split_tolerance}; }
  /// Resolution of a free face, along which the skin is so long [m].
  FaceResolution face(double length) const;
};

/// Short waves reach from the slider to its nearest image in a face, at least over most of the
/// thickness and at most over some of it: what a face nearer than half of that does to the shorter
/// waves is left out.
SkinResolution skin_resolution(const std::vector<ElasticLayer>& layers, const Clearance& clearance,
                               SkinPurpose purpose = SkinPurpose::results);

} // namespace ionskin::finite_layers
