// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/path/contact_box.hpp"

#include "ionskin/laws/friction/friction_law.hpp"
#include "ionskin/mechanics/skin/skin_reach.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace ionskin::mechanics {
namespace {

/// Widens a box by the swing of a slider on a drive that halts: its speed over the natural angular
/// frequency.
void add_swing(const Case& input, MotionBox& box) {
  constexpr double most = 0.5; // largest part of the room beside the box
  const double seconds = input.motion.drive.natural_period() / (2 * std::numbers::pi);
  const std::array<double, 2> skin{input.skin.length, input.skin.width};
  const double clearance = clearance_of_swings(input.skin);
  const auto half_size = input.slider.flat_half_size();
  std::array<double, 2> fastest{};
  for (const MotionLeg& leg : motion_legs(input.motion, input.slider)) {
    for (std::size_t d = 0; d < 2 && leg.touches() && leg.duration > 0; ++d) {
      fastest[d] = std::max(fastest[d], std::abs(leg.to[d] - leg.from[d]) / leg.duration);
    }
  }
  for (std::size_t d = 0; d < 2; ++d) {
    const double swing = fastest[d] * seconds;
    const double below = std::max(0.0, box.low[d] - half_size[d]),
                 above = std::max(0.0, skin[d] - half_size[d] - box.high[d]);
    const auto part = [&](double room) {
      return std::min({swing, most * room, std::max(0.0, room - clearance)});
    };
    box.low[d] -= part(below);
    box.high[d] += part(above);
  }
}

} // namespace

std::optional<MotionBox> contact_box(const Case& input) {
  std::optional<MotionBox> box;
  const auto include = [&](const std::array<double, 2>& place) {
    if (!box) {
      box = MotionBox{place, place};
    }
    for (std::size_t d = 0; d < 2; ++d) {
      box->low[d] = std::min(box->low[d], place[d]);
      box->high[d] = std::max(box->high[d], place[d]);
    }
  };
  const bool adheres = laws::friction_law(input.contact.law).adheres;
  bool held = false; // true while adhesion holds the slider, also where a leg only pulls
  for (const MotionLeg& leg : motion_legs(input.motion, input.slider)) {
    held = adheres && (held || leg.touches());
    if (held) {
      include(leg.from);
      include(leg.to);
      held = leg.to_level.is_force || leg.to_level.touches();
    } else if (leg.touches()) {
      // The whole leg may touch where a height turns into a force.
      const ContactPart part = contact_part(leg);
      include(part.from);
      include(part.to);
    }
  }
  if (box && input.motion.drive.given()) {
    add_swing(input, *box);
  }
  return box;
}

} // namespace ionskin::mechanics
