// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/engine/drive_room.hpp"

#include "ionskin/base/error.hpp"

#include <fmt/format.h>

#include <algorithm>
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

std::optional<MotionBox> widened_box(const Case& input, const MotionBox& box, const MotionBox& room,
                                     const ContactSolution& solution) {
  constexpr double near_enough = 1e-3; // of the skin: there the compliance hardly changes
  constexpr double growth = 1.2;
  const std::array<double, 2> skin{input.skin.length, input.skin.width};
  MotionBox wider = box;
  for (const SteppedInstant& instant : solution.stepped) {
    for (std::size_t d = 0; d < 2 && instant.state; ++d) {
      wider.low[d] = std::min(wider.low[d], instant.centre[d]);
      wider.high[d] = std::max(wider.high[d], instant.centre[d]);
    }
  }
  bool stays = true;
  for (std::size_t d = 0; d < 2; ++d) {
    const double low = box.low[d] - wider.low[d], high = wider.high[d] - box.high[d];
    stays = stays && std::max(low, high) <= near_enough * skin[d];
    wider.low[d] = std::max(box.low[d] - growth * low, std::min(box.low[d], room.low[d]));
    wider.high[d] = std::min(box.high[d] + growth * high, std::max(box.high[d], room.high[d]));
  }
  return stays ? std::nullopt : std::optional(wider);
}

void require_unshared(const Case& input, const MotionBox& needed) {
  if (input.numerics.shared.given()) {
    throw SolverError(
        fmt::format("the slider on its drive leaves numerics.shared_positions: its centre goes "
                    "from {:.4g} mm to {:.4g} mm along x and from {:.4g} mm to {:.4g} mm along y",
                    needed.low[0] * 1e3, needed.high[0] * 1e3, needed.low[1] * 1e3,
                    needed.high[1] * 1e3),
        "widen numerics.shared_positions to hold that, or remove it");
  }
}

} // namespace ionskin::mechanics
