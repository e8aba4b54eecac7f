// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/engine/drive_room.hpp"

#include "ionskin/finite_layers/thickness/elastic_layer.hpp"
#include "ionskin/mechanics/skin/skin_reach.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace ionskin::mechanics {
namespace {

/// Largest load on the full skin [N]: the largest prescribed force, or the force of the deepest
/// indentation if the layers were squeezed like columns.
double largest_load(const Case& input, const mesh::Footprint& footprint) {
  const mesh::HeaviestLoad heaviest = mesh::heaviest_load(input);
  double compliance = 0; // of a column in confined compression [m/Pa]
  for (const finite_layers::ElasticLayer& layer : finite_layers::elastic_layers(input.skin)) {
    compliance += layer.thickness / layer.oedometric_modulus();
  }
  const double area = 4 * footprint.half_size[0] * footprint.half_size[1];
  return std::max(heaviest.force, heaviest.indentation / compliance * area);
}

} // namespace

MotionBox room_on_skin(const Case& input, const mesh::Footprint& footprint) {
  constexpr double margin = 1e-3; // over the skin's size; the mesh needs room at the edges
  MotionBox room{{}, {input.skin.length, input.skin.width}};
  for (std::size_t d = 0; d < 2; ++d) {
    if (d == 1 && covers_width(input)) {
      continue; // the slider does not yield along y
    }
    const double edge = footprint.half_size[d] + margin * room.high[d];
    room.low[d] = edge;
    room.high[d] -= edge;
  }
  return room;
}

MotionBox expected_places(const Case& input, const MotionBox& touching,
                          const mesh::Footprint& footprint) {
  if (!input.motion.drive.given()) {
    return touching;
  }
  // A slider that sticks and slips swings at most by twice what friction stretches the spring by.
  const double swing =
      2 * input.contact.friction * largest_load(input, footprint) / input.motion.drive.stiffness;
  const MotionBox room = room_on_skin(input, footprint);
  const std::array<double, 2> size{input.skin.length, input.skin.width};
  const double clearance = clearance_of_swings(input.skin);
  MotionBox places = touching;
  for (std::size_t d = 0; d < 2; ++d) {
    if (touching.low[d] == touching.high[d]) {
      continue; // friction pulls along the motion
    }
    const double low = std::max(room.low[d], footprint.half_size[d] + clearance),
                 high = std::min(room.high[d], size[d] - footprint.half_size[d] - clearance);
    places.low[d] = std::min(touching.low[d], std::max(low, touching.low[d] - swing));
    places.high[d] = std::max(touching.high[d], std::min(high, touching.high[d] + swing));
  }
  return places;
}

} // namespace ionskin::mechanics
