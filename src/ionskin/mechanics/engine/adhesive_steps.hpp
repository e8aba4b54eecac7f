// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/mechanics/engine/leg_steps.hpp"

namespace ionskin::mechanics {

/// Steps of a slider with adhesion. A step in which the contact may jump is halved, to locate the
/// jump in time. A jump that remains in the shortest step loses energy, which is summed up.
class AdhesiveSteps : public LegSteps {
public:
  using LegSteps::LegSteps;
  double advance(const MotionLeg& leg, const LegLevels& levels, double from, double to,
                 const PassedSink& passed) override;
  double adhesion_loss() const override { return loss_; }

private:
  void step(const MotionLeg& leg, const LegLevels& levels, double from, double to, int depth,
            const PassedSink& passed);

  double loss_ = 0; ///< on the meshed part [J]
};

} // namespace ionskin::mechanics
