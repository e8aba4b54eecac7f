// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/engine/adhesive_steps.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/mechanics/surface/adhesion_energy.hpp"

namespace ionskin::mechanics {
namespace {

/// Number of times that a step which may have jumped is halved, to locate the jump.
constexpr int halvings_of_jump = 8;

} // namespace

void AdhesiveSteps::step(const MotionLeg& leg, const LegLevels& levels, double from, double to,
                         int depth, const PassedSink& passed) {
  const bool shortest = depth == halvings_of_jump;
  // Under a given force, `passed` returns the height at which the skin carries the slider, or at
  // which the slider came off.
  const double height_before = shortest ? passed({from, levels.height(from), true}) : 0;
  const SlidingContact::Moment before = contact().moment();
  const double energy = contact().energy();
  bool solved = false;
  try {
    contact().step((to - from) * leg.duration, leg.centre(to * leg.duration), levels.load(to));
    solved = true;
  } catch (const SolverError&) {
    if (shortest) {
      throw;
    }
  }
  if (!shortest && (!solved || contact().may_have_jumped())) {
    contact().go_back(before);
    step(leg, levels, from, 0.5 * (from + to), depth + 1, passed);
    step(leg, levels, 0.5 * (from + to), to, depth + 1, passed);
    return;
  }
  count_step();
  const bool jumps = contact().may_have_jumped();
  const double height = passed({to, levels.height(to), jumps});
  if (jumps) {
    loss_ += work_on_skin(before.state, contact().state(), height_before - height) -
             (contact().energy() - energy);
  }
}

double AdhesiveSteps::advance(const MotionLeg& leg, const LegLevels& levels, double from, double to,
                              const PassedSink& passed) {
  step(leg, levels, from, to, 0, passed);
  return to;
}

} // namespace ionskin::mechanics
