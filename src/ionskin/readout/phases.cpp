// SPDX-License-Identifier: Apache-2.0
#include "ionskin/readout/phases.hpp"

#include <algorithm>
#include <cmath>

namespace ionskin::readout {
namespace {

// Event times are sums of durations. Their rounding errors must not move them into the next phase.
constexpr double relative_rounding = 1e-10;

std::optional<SliderLevel> given_level(const MotionLeg& leg, double since_begin, double rounding) {
  if (since_begin >= leg.duration - rounding) {
    return leg.to_level;
  }
  if (since_begin <= 0) {
    return leg.from_level;
  }
  if (leg.from_level.is_force != leg.to_level.is_force) {
    return std::nullopt;
  }
  const double from = leg.from_level.value, to = leg.to_level.value;
  return SliderLevel{leg.to_level.is_force, from + since_begin / leg.duration * (to - from)};
}

} // namespace

MotionPhases::MotionPhases(const Motion& motion, const Slider& slider)
    : legs_(motion_legs(motion, slider)), cycles_(motion.cycles), duration_(legs_.back().end()) {}

MotionInstant MotionPhases::at(double time) const {
  const double rounding = relative_rounding * duration_ * cycles_;
  const double cycles_passed = std::ceil((time - rounding) / duration_);
  MotionInstant at;
  at.cycle = std::clamp(static_cast<int>(cycles_passed), 1, cycles_);
  const double local = time - (at.cycle - 1) * duration_;
  const auto leg =
      std::partition_point(legs_.begin(), legs_.end() - 1, [&](const MotionLeg& candidate) {
        return candidate.end() + rounding < local;
      });
  at.phase = name(leg->phase);
  at.centre = leg->centre(local - leg->begin);
  at.level = given_level(*leg, local - leg->begin, rounding);
  return at;
}

double end_of_touchdown(const Motion& motion, const Slider& slider) {
  for (const MotionLeg& leg : motion_legs(motion, slider)) {
    if (leg.lands()) {
      return leg.end();
    }
  }
  return 0;
}

double middle_of_slide(const Motion& motion, const Slider& slider) {
  const MotionLeg slide = whole_slide(motion_legs(motion, slider));
  return slide.begin + 0.5 * slide.duration;
}

double end_of_slide(const Motion& motion, const Slider& slider) {
  return whole_slide(motion_legs(motion, slider)).end();
}

} // namespace ionskin::readout
