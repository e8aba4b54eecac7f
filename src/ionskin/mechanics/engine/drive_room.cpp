// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/engine/drive_room.hpp"

#include <array>
#include <cstddef>

namespace ionskin::mechanics {

MotionBox room_on_skin(const Case& input, const mesh::Footprint& footprint) {
  constexpr double margin = 1e-3; // of the skin; the mesh needs some room at its edges
  MotionBox room{{}, {input.skin.length, input.skin.width}};
  for (std::size_t d = 0; d < 2; ++d) {
    if (d == 1 && covers_width(input)) {
      continue; // it does not yield along y
    }
    const double edge = footprint.half_size[d] + margin * room.high[d];
    room.low[d] = edge;
    room.high[d] -= edge;
  }
  return room;
}

} // namespace ionskin::mechanics
