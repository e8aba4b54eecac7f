// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/finite_layers/fields/face_strain.hpp"
#include "ionskin/finite_layers/fields/field_skin.hpp"

#include <vector>

namespace ionskin::finite_layers {

/// Answers of the modes of a skin to motions of its free faces, from which `FaceFields` makes
/// strains.
struct FieldFaces {
  /// Answers to the sides: even modes across the skin and, unless loads are symmetric, odd modes.
  /// Empty where rollers hold the sides.
  std::vector<FaceModes> sides;
  std::vector<FaceModes> ends; ///< answers to the ends, in the order of `FreeEnds::modes`

  /// Calculates the answers.
  /// @param mirrored true if all loads are symmetric about the middle of the width
  /// @param threads number of threads to use
  FieldFaces(const FieldSkin& skin, bool mirrored, int threads);
};

} // namespace ionskin::finite_layers
