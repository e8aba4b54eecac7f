// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/finite_layers/faces/free_ends.hpp"
#include "ionskin/finite_layers/faces/free_sides.hpp"
#include "ionskin/finite_layers/faces/thickness_column.hpp"
#include "ionskin/finite_layers/fields/field_skin.hpp"
#include "ionskin/finite_layers/plane/box_modes.hpp"
#include "ionskin/finite_layers/plane/radial_compliance.hpp"
#include "ionskin/finite_layers/skin/skin_resolution.hpp"

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace ionskin::finite_layers {

/// Key of a `LayerBox`: every property in which two of them can differ.
struct LayerBoxKey {
  std::vector<ElasticLayer> layers; ///< bottom to top
  std::size_t core = 0;             ///< index of the core in `layers`
  double length = 0, width = 0;     ///< [m]
  bool free_sides = true;           ///< true: sides free of stress; false: sides on rollers
  /// True if all loads are symmetric about the middle of the width, so that odd modes are not made.
  bool mirrored = false;
  SkinResolution resolution;

  /// Collects the key from a skin.
  /// @param mirrored_loads value of `mirrored`
  LayerBoxKey(const Skin& skin, const SkinResolution& resolved, bool mirrored_loads);
  bool operator==(const LayerBoxKey&) const = default;
};

/// Skin on its rigid base without a load: all operators that do not depend on the contact cells,
/// and are therefore shared by all sliders on the skin. Thread-safe.
class LayerBox {
public:
  /// Makes all operators.
  /// @param threads number of threads to use
  LayerBox(LayerBoxKey made_of, int threads);
  LayerBox(const LayerBox&) = delete; // its parts point at each other
  LayerBox& operator=(const LayerBox&) = delete;

  LayerBoxKey key;
  SurfaceCompliance surface;
  PlaneCompliance short_waves;
  BoxModes modes;
  ThicknessColumn column;
  std::optional<FreeSides> sides; ///< empty where rollers hold the sides
  std::optional<FreeEnds> ends;
  FieldSkin fields; ///< pointers to these parts, for the calculation of strains
};

/// Makes the box of a key, or returns the stored one if the last call had the same key: many
/// contacts on one skin share a box.
/// @param threads number of threads to use
std::shared_ptr<const LayerBox> layer_box(const LayerBoxKey& key, int threads);

} // namespace ionskin::finite_layers
