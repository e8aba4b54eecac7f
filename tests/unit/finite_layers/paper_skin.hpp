// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/finite_layers/thickness/elastic_layer.hpp"

#include <vector>

namespace ionskin::finite_layers {

inline ElasticLayer elastic_layer(double youngs_modulus, double poissons_ratio, double thickness) {
  return {youngs_modulus * poissons_ratio / ((1 + poissons_ratio) * (1 - 2 * poissons_ratio)),
          youngs_modulus / (2 * (1 + poissons_ratio)), thickness};
}

/// Nafion between two films of platinum, as in cases/paper.toml.
inline std::vector<ElasticLayer> paper_skin() {
  return {elastic_layer(168e9, 0.38, 10e-6), elastic_layer(249e6, 0.49, 180e-6),
          elastic_layer(168e9, 0.38, 10e-6)};
}

/// Skin of some size with the layers of `paper_skin`.
inline Skin skin_of_size(double length, double width) {
  const Material platinum{"platinum", 168e9, 0.38}, nafion{"nafion", 249e6, 0.49};
  Skin skin;
  skin.length = length;
  skin.width = width;
  skin.layers = {{"bottom electrode", LayerRole::electrode, platinum, 10e-6},
                 {"core", LayerRole::core, nafion, 180e-6},
                 {"top electrode", LayerRole::electrode, platinum, 10e-6}};
  return skin;
}

} // namespace ionskin::finite_layers
