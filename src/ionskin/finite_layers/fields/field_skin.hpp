// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/finite_layers/faces/free_ends.hpp"

#include <cstddef>
#include <memory>
#include <vector>

namespace ionskin::finite_layers {

struct FieldFaces;

/// A skin whose fields are asked for. Its pointers outlive them.
struct FieldSkin {
  std::vector<ElasticLayer> layers;        ///< bottom to top
  std::size_t core = 0;                    ///< index of the core; all others are electrodes
  double length = 0, width = 0;            ///< [m]
  const ThicknessColumn* column = nullptr; ///< the one that sides and ends were made with
  const FreeSides* sides = nullptr;        ///< null where rollers hold them
  const FreeEnds* ends = nullptr;          ///< likewise
  std::shared_ptr<const FieldFaces> faces = nullptr; ///< made of the others
};

} // namespace ionskin::finite_layers
