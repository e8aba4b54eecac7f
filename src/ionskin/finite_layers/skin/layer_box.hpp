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

/// Key of a box of layers: every property that distinguishes it.
struct LayerBoxKey {
  std::vector<ElasticLayer> layers; ///< bottom to top
  std::size_t core = 0;             ///< index of the layer
  double length = 0, width = 0;     ///< [m]
  bool free_sides = true;           ///< or rollers
  bool mirrored = false;            ///< loaded alike on both sides of the middle of the width alone
  SkinResolution resolution;

  LayerBoxKey(const Skin& skin, const SkinResolution& resolved, bool mirrored_loads);
  bool operator==(const LayerBoxKey&) const = default;
};

/// A skin on its rigid base without anything on it: all that does not depend on contact cells.
/// Thread-safe.
class LayerBox {
public:
  /// @param threads that make it
  LayerBox(LayerBoxKey made_of, int threads);
  LayerBox(const LayerBox&) = delete; // its parts point at each other
  LayerBox& operator=(const LayerBox&) = delete;

  LayerBoxKey key;
  SurfaceCompliance surface;
  PlaneCompliance short_waves;
  BoxModes modes;
  ThicknessColumn column;
  std::optional<FreeSides> sides; ///< none where rollers hold them
  std::optional<FreeEnds> ends;
  FieldSkin fields; ///< the same for its fields
};

/// The box that was asked for last is kept: many contacts on one skin share it.
std::shared_ptr<const LayerBox> layer_box(const LayerBoxKey& key, int threads);

} // namespace ionskin::finite_layers
