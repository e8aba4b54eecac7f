// SPDX-License-Identifier: Apache-2.0
#include "ionskin/case/case.hpp"

#include "ionskin/case/slider_motion.hpp"
#include "ionskin/shapes/posed.hpp"

#include <utility>

namespace ionskin {

shapes::Plan Slider::plan() const {
  const shapes::Plan own{size, profile_heights};
  if (pose == shapes::Pose{} && !changing.any()) {
    return own;
  }
  return {shapes::posed_size(*shapes::shape(shape, parameters), own, pose, changing),
          profile_heights};
}

std::unique_ptr<const shapes::Shape> Slider::underside(const shapes::Pose& at) const {
  auto body = shapes::shape(shape, parameters);
  if (at == shapes::Pose{} && !changing.any()) {
    return body;
  }
  return std::make_unique<const shapes::Posed>(std::move(body), shapes::Plan{size, profile_heights},
                                               at, changing);
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

std::vector<Case> cases_of_sliders(const Case& input) {
  Case alone = input;
  alone.further_sliders.clear();
  std::vector<Case> cases(1 + input.further_sliders.size(), alone);
  for (std::size_t i = 0; i < input.further_sliders.size(); ++i) {
    const FurtherSlider& further = input.further_sliders[i];
    cases[i + 1].slider = further.slider;
    cases[i + 1].motion = further.motion;
    cases[i + 1].contact = further.contact;
  }
  return cases;
}

bool covers_width(const Case& input) {
  if (input.skin.sides != SideCondition::symmetry)
    return false;
  const MotionBox box = motion_box(input.motion, input.slider);
  const double half_size = input.slider.flat_half_size()[1];
  return half_size > 0 && input.slider.symmetric()[1] && box.high[1] - half_size <= 0 &&
         box.low[1] + half_size >= input.skin.width;
}

} // namespace ionskin
