// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/contact_path.hpp"

#include <cmath>

namespace ionskin::mechanics {
namespace {

/// Time the slider needs for a change of indentation, all of it within the contact part of a ramp.
double ramp_time(double ramp_duration, const Motion& motion, double fraction_of_preload) {
  return ramp_duration * fraction_of_preload * motion.preload / (motion.gap + motion.preload);
}

} // namespace

SurfaceState touch_down(const ContactProblem& problem, const Motion& motion,
                        const CellVector& surface_before) {
  const CellVector none(3 * problem.area.size(), 0.0);
  const SliderStep step{{LoadKind::indentation, motion.preload},
                        {0, 0},
                        ramp_time(motion.touchdown, motion, 1),
                        surface_before.empty() ? none : surface_before};
  return solve_contact_step(problem, step, none);
}

double onset_travel(const SurfaceState& touchdown, const SurfaceState& steady,
                    const std::array<double, 2>& direction, const PathSteps& steps) {
  double displacement = 0;
  for (std::size_t i = 0; i < steady.surface.size(); i += 3) {
    displacement += direction[0] * (steady.surface[i + 1] - touchdown.surface[i + 1]) +
                    direction[1] * (steady.surface[i + 2] - touchdown.surface[i + 2]);
  }
  const double cells = static_cast<double>(steady.surface.size()) / 3;
  return steps.onset_travel_ratio * std::abs(displacement) / cells;
}

std::vector<PathPoint> slide_onset(const ContactProblem& problem, const Motion& motion,
                                   const std::array<double, 2>& direction,
                                   const SurfaceState& touchdown, double travel,
                                   const PathSteps& steps) {
  const double speed = motion.stroke / motion.slide;
  const double total = (std::pow(steps.onset_growth, steps.onset) - 1) / (steps.onset_growth - 1);
  double increment = travel / total, position = 0;
  std::vector<PathPoint> points;
  SurfaceState state = touchdown;
  for (int i = 0; i < steps.onset; ++i) {
    const SliderStep step{{LoadKind::indentation, motion.preload},
                          {increment * direction[0], increment * direction[1]},
                          increment / speed,
                          state.surface};
    state = solve_contact_step(problem, step, state.force);
    position = i + 1 == steps.onset ? travel : position + increment;
    points.push_back({position, state});
    increment *= steps.onset_growth;
  }
  return points;
}

std::vector<PathPoint> lift_off(const ContactProblem& problem, const Motion& motion,
                                const SurfaceState& loaded, const PathSteps& steps) {
  std::vector<PathPoint> points;
  SurfaceState state = loaded;
  for (int i = steps.lift_off - 1; i >= 0; --i) {
    const double fraction = static_cast<double>(i) / steps.lift_off;
    const SliderStep step{{LoadKind::indentation, fraction * motion.preload},
                          {0, 0},
                          ramp_time(motion.lift, motion, 1.0 / steps.lift_off),
                          state.surface};
    state = solve_contact_step(problem, step, state.force);
    points.push_back({fraction, state});
  }
  return points;
}

} // namespace ionskin::mechanics
