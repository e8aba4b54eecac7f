// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/mechanics/engine/leg_steps.hpp"

namespace ionskin::mechanics {

/// Steps of a slider that adhesion holds: halved where the contact may jump, to find where. What
/// jumps in the shortest step nevertheless loses energy, which is counted.
class AdhesiveSteps : public LegSteps {
public:
  using LegSteps::LegSteps;
  double advance(const MotionLeg& leg, const LegLevels& levels, double from, double to,
                 const PassedSink& passed) override;
  double adhesion_loss() const override { return loss_; }

private:
  void step(const MotionLeg& leg, const LegLevels& levels, double from, double to, int depth,
            const PassedSink& passed);

  double loss_ = 0;
};

} // namespace ionskin::mechanics
