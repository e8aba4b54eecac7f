// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/path/slider_track.hpp"

#include "ionskin/case/slider_motion.hpp"

#include <algorithm>
#include <cmath>

namespace ionskin::mechanics {

SliderTrack::SliderTrack(const Case& input) {
  const MotionLeg leg = first_slide(motion_legs(input.motion, input.slider));
  start = leg.from;
  direction = leg.direction();
  stroke = leg.length();
}

std::array<double, 2> SliderTrack::centre(double arc_length) const {
  return {start[0] + arc_length * direction[0], start[1] + arc_length * direction[1]};
}

std::array<double, 2> CanonicalPosition::reflected(const std::array<double, 2>& vector) const {
  return {reflect[0] ? -vector[0] : vector[0], reflect[1] ? -vector[1] : vector[1]};
}

CanonicalPosition canonical_position(const Skin& skin, const std::array<double, 2>& centre) {
  CanonicalPosition result;
  const std::array<double, 2> size{skin.length, skin.width};
  for (std::size_t d = 0; d < 2; ++d) {
    // A centre on the symmetry line stays unreflected whatever the rounding.
    result.reflect[d] = centre[d] > size[d] / 2 * (1 + 1e-12);
    result.centre[d] = result.reflect[d] ? size[d] - centre[d] : centre[d];
  }
  return result;
}

} // namespace ionskin::mechanics
