// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/slider_motion.hpp"
#include "ionskin/mechanics/engine/driven_steps.hpp"
#include "ionskin/mechanics/engine/leg_steps.hpp"
#include "ionskin/mechanics/engine/onset_travel.hpp"
#include "ionskin/mechanics/engine/sliding_contact.hpp"
#include "ionskin/mechanics/path/path_steps.hpp"

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace ionskin::mechanics {

/// An instant that the stepper passes.
struct StepPoint {
  double time = 0;                ///< since the begin of the cycle [s]
  std::array<double, 2> centre{}; ///< [m]
  double height = 0;              ///< of the underside above the undeformed top face [m]
  bool touches = false;           ///< true if the contact carries load
  bool required = false; ///< an instant that must stay: an event, or one that was asked for
  std::array<double, 2> drive_force{}; ///< of a drive on the slider; 0 without load [N]
};

/// Options by which a motion is cut into steps.
struct StepperOptions {
  PathSteps steps;
  double longest_travel = 0;       ///< of a step [m]
  double longest_turn = 0.05;      ///< of a step about z [rad]
  double half_diagonal = 0;        ///< of the footprint [m]
  double heaviest_indentation = 0; ///< [m]
  double heaviest_force = 0;       ///< on the meshed part [N]
  double meshed_share = 1;         ///< part of the force that the mesh carries
  std::vector<double> instants;    ///< instants that must be passed, ascending [s]
  /// Instants between which others move the skin evenly, ascending; empty without others [s].
  std::vector<double> others;
  std::optional<DriveOptions> drive; ///< drive that the slider hangs on
};

/// Moves a slider through the legs of a cycle. A leg is cut where the slider lands and leaves, so
/// that its load changes by a small part of the heaviest in each step, by the travel of an onset,
/// and at the instants that were asked for; `LegSteps` go from cut to cut.
class MotionStepper {
public:
  using Sink = std::function<void(const StepPoint&, const SlidingContact&)>;

  /// @param sink called at every instant passed, in order; an instant may come twice, once for what
  /// ends and once for what begins there
  MotionStepper(SlidingContact& contact, StepperOptions options, Sink sink);

  void follow(const MotionLeg& leg);

  const std::vector<double>& events() const { return events_; }
  const std::vector<std::array<double, 2>>& onsets() const { return onsets_; }
  int steps() const { return steps_->steps(); }
  double adhesion_loss() const { return steps_->adhesion_loss(); } ///< on the meshed part [J]

private:
  void touch(const MotionLeg& leg);
  bool lands_on_the_way(const MotionLeg& leg, const LegLevels& levels);
  void begin_travel(const MotionLeg& leg, bool lands, double begin);
  void go(const MotionLeg& leg, const LegLevels& levels);
  double next_fraction(const MotionLeg& leg, const LegLevels& levels, double at) const;
  double share_of_turn(const MotionLeg& leg) const;
  int touchdown_steps() const;
  void note_change(const MotionLeg& leg, const LegLevels& levels);
  bool may_touch(const MotionLeg& leg) const;
  double emit(const MotionLeg& leg, double fraction, std::optional<double> height, bool required);
  bool asked_for(double time) const;
  void note_event(double time);

  SlidingContact& contact_;
  StepperOptions options_;
  Sink sink_;
  std::unique_ptr<LegSteps> steps_;
  OnsetTravel travel_;
  double rest_step_ = 0; ///< longest of the next step while the slider rests; 0: moves
  bool onset_open_ = false;
  bool travels_ = false, loads_ = false; ///< true if the leg before moved, and changed its level
  std::vector<double> events_;
  std::vector<std::array<double, 2>> onsets_;
  double last_height_ = 0; ///< of the slider, as it was last reported [m]
};

} // namespace ionskin::mechanics
