// SPDX-License-Identifier: Apache-2.0
#include "ionskin/live/training/touch_range.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/mechanics/path/contact_box.hpp"

#include <algorithm>
#include <cmath>

namespace ionskin::live {
namespace {

constexpr double usual_speed = 3e-3; ///< speed for a case whose slider never slides [m/s]

} // namespace

TouchRange touch_range(const Case& input) {
  const auto box = mechanics::contact_box(input);
  if (!box) {
    throw UserError("the slider never touches the skin: there is nothing to train\n"
                    "  = lower the slider, such as by a larger motion.preload");
  }
  TouchRange range{*box, false, 0, 0};
  for (const MotionLeg& leg : motion_legs(input.motion, input.slider)) {
    for (const SliderLevel& level : {leg.from_level, leg.to_level}) {
      if (level.touches() && level.is_force != range.is_force) {
        range.is_force = level.is_force; // a force takes precedence over a height
        range.heaviest = 0;
      }
      if (level.touches() && level.is_force == range.is_force) {
        range.heaviest = std::max(range.heaviest, std::abs(level.value));
      }
    }
    if (leg.slides()) {
      range.fastest = std::max(range.fastest, leg.length() / leg.duration);
    }
  }
  if (range.fastest == 0) {
    range.fastest = usual_speed;
  }
  return range;
}

} // namespace ionskin::live
