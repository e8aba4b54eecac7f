// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/slider_motion.hpp"
#include "ionskin/mechanics/engine/compliant_drive.hpp"
#include "ionskin/mechanics/engine/leg_steps.hpp"

#include <array>
#include <cstddef>

namespace ionskin::mechanics {

/// Options for the steps of a slider on a drive.
struct DriveOptions {
  Drive drive;
  std::array<bool, 2> along{true, true}; ///< true along x and y where the slider yields
  /// Tolerance of a step's error of position, over the largest distance so far between slider and
  /// end of the drive, or over `longest_travel` where that is larger [1].
  double tolerance = 0;
  double longest_travel = 0;  ///< of the slider in one step [m]
  MotionBox room;             ///< box that the slider's centre must not leave [m]
  std::size_t most_tries = 0; ///< contact solutions before the motion is given up
};

/// Steps of a slider on a compliant drive. Each step is as long as the position at its end agrees,
/// within a tolerance, with the extrapolation from its begin: steps are short while the slider
/// swings, starts to slip or stops, and long while it sticks or slides evenly.
class DrivenSteps : public LegSteps {
public:
  DrivenSteps(SlidingContact& contact, const DriveOptions& options, double meshed_share);

  /// Takes one step. Throws SolverError when the contact has no solution, when the slider leaves
  /// its room, and when steps become too many.
  double advance(const MotionLeg& leg, const LegLevels& levels, double from, double to,
                 const PassedSink& passed) override;
  /// Puts the slider at the end of the drive.
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
  double longest_ = 0;    ///< longest next step [s]; 0: no limit
  double yield_ = 0;      ///< largest distance so far between slider and end of the drive [m]
  std::size_t tries_ = 0; ///< contact solutions so far
};

} // namespace ionskin::mechanics
