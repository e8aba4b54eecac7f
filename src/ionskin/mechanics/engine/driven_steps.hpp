// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/slider_motion.hpp"
#include "ionskin/mechanics/engine/compliant_drive.hpp"
#include "ionskin/mechanics/engine/leg_steps.hpp"

#include <array>
#include <cstddef>

namespace ionskin::mechanics {

/// Options of a slider on a drive.
struct DriveOptions {
  Drive drive;
  std::array<bool, 2> along{true, true}; ///< axes along which the slider yields
  double tolerance = 0;                  ///< of a step, of the way that the slider may yield [1]
  double longest_travel = 0;             ///< of the slider in a step [m]
  MotionBox room;                        ///< box that its centre must not leave [m]
  std::size_t most_tries = 0;            ///< contacts solved until the motion is given up
};

/// Steps of a slider on a compliant drive, as long as the place at their end is foreseen within a
/// tolerance from velocity and acceleration at their begin: short while the slider swings, slips or
/// catches, long while it sticks or slides evenly.
class DrivenSteps : public LegSteps {
public:
  DrivenSteps(SlidingContact& contact, const DriveOptions& options, double meshed_share);

  /// One step. Throws SolverError also when the slider leaves its room, or steps get nowhere.
  double advance(const MotionLeg& leg, const LegLevels& levels, double from, double to,
                 const PassedSink& passed) override;
  /// The slider stands at the end of the drive.
  void land(const MotionLeg& leg, double fraction) override;
  std::array<double, 2> centre(const MotionLeg& leg, double fraction) const override;
  std::array<double, 2> drive_force(const MotionLeg& leg, double fraction) const override;
  bool follows_path() const override { return false; }

private:
  double longest_step(const MotionLeg& leg) const;
  void require_room(double time) const;
  void require_progress(double time, double time_step);

  DriveOptions options_;
  CompliantDrive drive_;
  double meshed_share_;
  double longest_ = 0; ///< next step at most [s]; 0 for any
  double yield_ = 0;   ///< largest so far, between slider and end of the drive [m]
  std::size_t tries_ = 0;
};

} // namespace ionskin::mechanics
