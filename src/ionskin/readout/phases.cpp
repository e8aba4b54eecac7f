// SPDX-License-Identifier: Apache-2.0
#include "ionskin/readout/phases.hpp"

#include <algorithm>
#include <cmath>

namespace ionskin::readout {
namespace {

// Event times are sums of durations: their rounding must not push them into the next phase.
constexpr double relative_rounding = 1e-10;

// A phase without duration is passed at its start.
double fraction(double time, double start, double duration) {
  if (duration <= 0) {
    return time >= start ? 1.0 : 0.0;
  }
  return std::clamp((time - start) / duration, 0.0, 1.0);
}

int cycle_at(const Motion& motion, double time, double rounding) {
  const double cycles_passed = std::ceil((time - rounding) / motion.cycle_duration());
  return std::clamp(static_cast<int>(cycles_passed), 1, motion.cycles);
}

const char* phase_at(const Motion& motion, double local, double rounding) {
  if (local <= motion.touchdown + rounding) {
    return "touchdown";
  }
  if (local <= motion.touchdown + motion.slide + rounding) {
    return "slide";
  }
  if (local <= motion.touchdown + motion.slide + motion.lift + rounding) {
    return "lift";
  }
  return "return";
}

} // namespace

MotionInstant motion_at(const Motion& motion, const Slider& slider, double time) {
  const double rounding = relative_rounding * motion.cycle_duration() * motion.cycles;
  MotionInstant at;
  at.cycle = cycle_at(motion, time, rounding);
  const double local = time - (at.cycle - 1) * motion.cycle_duration();
  at.phase = phase_at(motion, local, rounding);
  const double slide_start = motion.touchdown;
  const double lift_start = slide_start + motion.slide;
  const double return_start = lift_start + motion.lift;
  const double lowered =
      fraction(local, 0.0, motion.touchdown) - fraction(local, lift_start, motion.lift);
  const double advanced =
      fraction(local, slide_start, motion.slide) - fraction(local, return_start, motion.return_);
  at.slider_z = motion.gap - lowered * (motion.gap + motion.preload);
  at.slider_x = slider.start[0] + advanced * motion.stroke * motion.direction[0];
  return at;
}

double end_of_touchdown(const Motion& motion) {
  return motion.touchdown;
}

double middle_of_slide(const Motion& motion) {
  return motion.touchdown + 0.5 * motion.slide;
}

} // namespace ionskin::readout
