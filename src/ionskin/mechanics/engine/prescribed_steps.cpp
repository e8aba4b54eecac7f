// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/engine/prescribed_steps.hpp"

#include "ionskin/base/error.hpp"

namespace ionskin::mechanics {
namespace {

/// Number of times that a step without a solution is halved before the motion is given up.
constexpr int most_halvings = 6;

} // namespace

void PrescribedSteps::step(const MotionLeg& leg, const LegLevels& levels, double from, double to,
                           int depth) {
  try {
    contact().set_end_of_step(leg.begin + to * leg.duration);
    contact().step((to - from) * leg.duration, leg.centre(to * leg.duration), levels.load(to),
                   leg.pose(to * leg.duration));
    count_step();
  } catch (const SolverError&) {
    if (depth == most_halvings) {
      throw;
    }
    step(leg, levels, from, 0.5 * (from + to), depth + 1);
    step(leg, levels, 0.5 * (from + to), to, depth + 1);
  }
}

double PrescribedSteps::advance(const MotionLeg& leg, const LegLevels& levels, double from,
                                double to, const PassedSink& passed) {
  step(leg, levels, from, to, 0);
  passed({to, levels.height(to)});
  return to;
}

} // namespace ionskin::mechanics
