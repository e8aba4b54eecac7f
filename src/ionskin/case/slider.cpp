// SPDX-License-Identifier: Apache-2.0
#include "ionskin/case/case.hpp"

#include "ionskin/case/slider_motion.hpp"

namespace ionskin {

std::unique_ptr<const shapes::Shape> Slider::underside() const {
  return shapes::shape(shape, parameters);
}

bool Slider::sharp() const {
  return underside()->sharp();
}

std::array<double, 2> Slider::flat_half_size() const {
  return underside()->flat_half_size(plan());
}

std::array<bool, 2> Slider::symmetric() const {
  return underside()->symmetric(plan());
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
