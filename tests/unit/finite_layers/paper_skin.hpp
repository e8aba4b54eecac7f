// SPDX-License-Identifier: Apache-2.0
#pragma once

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

} // namespace ionskin::finite_layers
