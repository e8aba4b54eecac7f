// SPDX-License-Identifier: Apache-2.0
#include "ionskin/case/case.hpp"

#include "ionskin/case/slider_motion.hpp"

namespace ionskin {

std::array<double, 2> Slider::flat_half_size() const {
  switch (shape) {
  case SliderShape::flat:
    return {size[0] / 2 - edge_radius, size[1] / 2 - edge_radius};
  case SliderShape::cylinder:
    return {0, size[1] / 2};
  case SliderShape::sphere:
  case SliderShape::profile:
    break;
  }
  return {0, 0};
}

std::array<bool, 2> Slider::symmetric() const {
  if (shape != SliderShape::profile)
    return {true, true};
  return {profile_heights.symmetric_x(), profile_heights.symmetric_y()};
}

bool covers_width(const Case& input) {
  if (input.skin.sides != SideCondition::symmetry)
    return false;
  const MotionBox box = motion_box(input.motion, input.slider);
  const double half_size = input.slider.flat_half_size()[1];
  return half_size > 0 && box.high[1] - half_size <= 0 &&
         box.low[1] + half_size >= input.skin.width;
}

} // namespace ionskin
