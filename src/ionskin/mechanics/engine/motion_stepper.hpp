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

/// Instant that the stepper passes, with the position of the slider.
struct StepPoint {
  double time = 0;                     ///< since the begin of the cycle [s]
  std::array<double, 2> centre{};      ///< of the slider [m]
  double height = 0;                   ///< of the underside above the undeformed top face [m]
  bool touches = false;                ///< true if the contact carries load
  bool required = false;               ///< true if it must be stored: an event, or requested
  std::array<double, 2> drive_force{}; ///< of a drive on the slider; 0 off the skin [N]
};

/// Options by which `MotionStepper` cuts a motion into steps.
struct StepperOptions {
  PathSteps steps;
  double longest_travel = 0;       ///< of the slider in one step [m]
  double longest_turn = 0.05;      ///< of the slider about z in one step [rad]
  double half_diagonal = 0;        ///< of the footprint [m]
  double heaviest_indentation = 0; ///< largest of the cycle [m]
  double heaviest_force = 0;       ///< largest of the cycle, on the meshed part [N]
  double meshed_share = 1;         ///< share of the force that the mesh carries, 1 or 0.5 [1]
  std::vector<double> instants;    ///< at which a step must end, ascending [s]
  /// Instants between which other sliders displace the skin linearly in time, ascending [s]; empty
  /// without other sliders. Steps end there, too.
  std::vector<double> others;
  std::optional<DriveOptions> drive; ///< empty without a drive
};

/// Moves a slider through the legs of one cycle. It cuts each leg where the slider lands and
/// leaves, at requested instants, so that each step changes the load by a small share of the
/// heaviest one, and so that an onset of sliding is resolved. `LegSteps` go from cut to cut.
class MotionStepper {
public:
  using Sink = std::function<void(const StepPoint&, const SlidingContact&)>;

  /// @param contact moved by this object; must outlive it
  /// @param sink called at every instant passed, in order. An instant may come twice, once for the
  ///   end of one state and once for the begin of the next
  MotionStepper(SlidingContact& contact, StepperOptions options, Sink sink);

  /// Moves the slider along a leg. Legs come in their order. Throws SolverError when the contact
  /// has no solution.
  void follow(const MotionLeg& leg);

  /// Events so far, as `ContactSolution::stepped_events` [s].
  const std::vector<double>& events() const { return events_; }
  /// Onsets of sliding so far, as `ContactSolution::stepped_onsets` [s].
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
  double rest_step_ = 0; ///< longest next step while the slider rests [s]; 0: it moves
  bool onset_open_ = false;
  bool travels_ = false, loads_ = false; ///< true if the last leg moved, and changed its level
  std::vector<double> events_;
  std::vector<std::array<double, 2>> onsets_;
  double last_height_ = 0; ///< of the slider, as last reported [m]
};

} // namespace ionskin::mechanics
