// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/skin/skin_reach.hpp"

#include "ionskin/finite_layers/skin/skin_resolution.hpp"

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

namespace {

finite_layers::SkinResolution resolution_of(const Skin& skin, const mesh::Footprint& footprint,
                                            const MotionBox& places) {
  const auto [ends, sides] = clearance(skin, footprint, places);
  return finite_layers::skin_resolution(skin, {ends, sides});
}

} // namespace

SkinWaves skin_waves(const Skin& skin, const mesh::Footprint& footprint, const MotionBox& places) {
  const finite_layers::SkinResolution resolution = resolution_of(skin, footprint, places);
  const auto waves = [&](double reach, double length) {
    return static_cast<double>(resolution.face(reach, length).modes);
  };
  return {resolution.reach, resolution.ends_reach, resolution.sides_reach,
          waves(resolution.ends_reach, skin.width), waves(resolution.sides_reach, skin.length)};
}

// Short waves reach over twice the clearance. Memory grows with the skin over the square of that
// reach; see planning::mechanics_cost.
double clearance_of_swings(const Skin& skin) {
  constexpr double most = 1000; // largest such ratio
  return 0.5 * std::sqrt(skin.length * skin.width / most);
}

double nodes_through_thickness(const Skin& skin) {
  const finite_layers::SkinResolution resolution = finite_layers::skin_resolution(skin, {});
  double nodes = 1;
  for (const finite_layers::ElementSizes& sizes : resolution.elements) {
    nodes += static_cast<double>(sizes.size()) * resolution.degree;
  }
  return nodes;
}

std::function<double(double x)> end_products(const Skin& skin, const mesh::Footprint& footprint,
                                             const MotionBox& places, double forces, bool half) {
  const finite_layers::SkinResolution beside = resolution_of(skin, footprint, places);
  const double nodes = nodes_through_thickness(skin);
  return [=, room = footprint.half_size[0], size = std::array{skin.length, skin.width}](double x) {
    const double reach = std::max(beside.ends_reach, 2 * (std::min(x, size[0] - x) - room));
    // Modes of one parity.
    const double along = 0.5 * static_cast<double>(beside.face(reach, size[0]).modes);
    const double unknowns = 0.5 * nodes * static_cast<double>(beside.face(reach, size[1]).modes);
    return (half ? 2 : 4) * unknowns * forces * (unknowns + 2 * forces + along);
  };
}

} // namespace ionskin::mechanics
