// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/finite_layers/fields/face_strain.hpp"
#include "ionskin/finite_layers/fields/field_skin.hpp"

#include <vector>

namespace ionskin::finite_layers {

/// Answer of the modes of a skin to motions of its free faces.
struct FieldFaces {
  /// Modes of the sides, even and, without a mirror, odd across the skin.
  std::vector<FaceModes> sides;
  std::vector<FaceModes> ends; ///< in the order of their motions

  /// @param mirrored whether loads are, in the middle of the width
  FieldFaces(const FieldSkin& skin, bool mirrored, int threads);
};

} // namespace ionskin::finite_layers
