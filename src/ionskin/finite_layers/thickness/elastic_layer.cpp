// SPDX-License-Identifier: Apache-2.0
#include "ionskin/finite_layers/thickness/elastic_layer.hpp"

namespace ionskin::finite_layers {

std::vector<ElasticLayer> elastic_layers(const Skin& skin) {
  std::vector<ElasticLayer> layers;
  for (const Layer& layer : skin.layers) {
    const double modulus = layer.material.youngs_modulus, nu = layer.material.poissons_ratio;
    layers.push_back(
        {modulus * nu / ((1 + nu) * (1 - 2 * nu)), modulus / (2 * (1 + nu)), layer.thickness});
  }
  return layers;
}

} // namespace ionskin::finite_layers
