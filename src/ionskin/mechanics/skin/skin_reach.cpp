// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/skin/skin_reach.hpp"

#include "ionskin/finite_layers/skin/skin_resolution.hpp"
#include "ionskin/finite_layers/thickness/elastic_layer.hpp"

#include <algorithm>
#include <cmath>
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

// Short waves reach over twice the clearance. Memory grows with the skin over the square of that
// reach; see planning::mechanics_cost.
double clearance_of_swings(const Skin& skin) {
  constexpr double most = 1000; // of that ratio
  return 0.5 * std::sqrt(skin.length * skin.width / most);
}

double short_wave_reach(const Skin& skin, const mesh::Footprint& footprint,
                        const MotionBox& places) {
  const auto [ends, sides] = clearance(skin, footprint, places);
  return finite_layers::skin_resolution(finite_layers::elastic_layers(skin), {ends, sides}).reach;
}

} // namespace ionskin::mechanics
