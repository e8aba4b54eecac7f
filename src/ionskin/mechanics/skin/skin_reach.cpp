// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/skin/skin_reach.hpp"

#include "ionskin/finite_layers/skin/skin_resolution.hpp"
#include "ionskin/finite_layers/thickness/elastic_layer.hpp"

#include <algorithm>
#include <cstddef>

namespace ionskin::mechanics {

std::array<double, 2> clearance(const Skin& skin, const mesh::Footprint& footprint,
                                const MotionBox& places) {
  const std::array<double, 2> size{skin.length, skin.width};
  std::array<double, 2> result{};
  for (std::size_t d = 0; d < 2; ++d) {
    const double room = std::min(places.low[d], size[d] - places.high[d]) - footprint.half_size[d];
    result[d] = std::max(0.0, room);
  }
  return result;
}

double short_wave_reach(const Skin& skin, const mesh::Footprint& footprint,
                        const MotionBox& places) {
  const auto [ends, sides] = clearance(skin, footprint, places);
  return finite_layers::skin_resolution(finite_layers::elastic_layers(skin), {ends, sides}).reach;
}

} // namespace ionskin::mechanics
