// SPDX-License-Identifier: Apache-2.0
#include "ionskin/finite_layers/thickness/elastic_layer.hpp"

namespace ionskin::finite_layers {

ElasticLayer elastic_layer(const Material& material, double thickness) {
  const double modulus = material.youngs_modulus, nu = material.poissons_ratio;
  return {modulus * nu / ((1 + nu) * (1 - 2 * nu)), modulus / (2 * (1 + nu)), thickness};
}

std::vector<ElasticLayer> elastic_layers(const Skin& skin) {
  std::vector<ElasticLayer> layers;
  for (const Layer& layer : skin.layers) {
    layers.push_back(elastic_layer(layer.material, layer.thickness));
  }
  return layers;
}

} // namespace ionskin::finite_layers
