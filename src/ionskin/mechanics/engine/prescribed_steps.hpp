// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/mechanics/engine/leg_steps.hpp"

namespace ionskin::mechanics {

/// Steps of a slider on a prescribed path. A step in which the contact has no solution is halved.
class PrescribedSteps : public LegSteps {
public:
  using LegSteps::LegSteps;
  double advance(const MotionLeg& leg, const LegLevels& levels, double from, double to,
                 const PassedSink& passed) override;

private:
  void step(const MotionLeg& leg, const LegLevels& levels, double from, double to, int depth);
};

} // namespace ionskin::mechanics
