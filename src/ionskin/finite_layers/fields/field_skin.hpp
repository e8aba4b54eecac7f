// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/finite_layers/faces/free_ends.hpp"

#include <cstddef>
#include <memory>
#include <vector>

namespace ionskin::finite_layers {

struct FieldFaces;

/// References to the parts of a skin whose strains are calculated. The parts must outlive every
/// object that is made from this one.
struct FieldSkin {
  std::vector<ElasticLayer> layers;        ///< bottom to top
  std::size_t core = 0;                    ///< index of the core; all others are electrodes
  double length = 0, width = 0;            ///< [m]
  const ThicknessColumn* column = nullptr; ///< elements that sides and ends were made with
  const FreeSides* sides = nullptr;        ///< null where rollers hold the sides
  const FreeEnds* ends = nullptr;          ///< null where rollers hold the ends
  /// Answers of the modes to motions of the faces, made from the other members.
  std::shared_ptr<const FieldFaces> faces = nullptr;
};

} // namespace ionskin::finite_layers
