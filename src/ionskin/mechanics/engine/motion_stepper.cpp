// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/engine/motion_stepper.hpp"

#include "ionskin/base/system/interrupt.hpp"
#include "ionskin/mechanics/engine/adhesive_steps.hpp"
#include "ionskin/mechanics/engine/prescribed_steps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace ionskin::mechanics {
namespace {

/// Steps while the slider rests and rate-dependent friction relaxes: first step over the duration
/// of the rest, and ratio of successive steps [1].
constexpr double first_of_rest = 1.0 / 1024, growth_of_rest = 1.5;
/// Difference of two instants that counts as rounding, over the time [1].
constexpr double instant_tolerance = 1e-12;

/// Makes the stepping method: for a slider on a drive, with adhesion, or on a rigid path.
std::unique_ptr<LegSteps> leg_steps(SlidingContact& contact, const StepperOptions& options) {
  if (options.drive) {
    return std::make_unique<DrivenSteps>(contact, *options.drive, options.meshed_share);
  }
  if (contact.range() > 0) {
    return std::make_unique<AdhesiveSteps>(contact);
  }
  return std::make_unique<PrescribedSteps>(contact);
}

} // namespace

MotionStepper::MotionStepper(SlidingContact& contact, StepperOptions options, Sink sink)
    : contact_(contact), options_(std::move(options)), sink_(std::move(sink)),
      steps_(leg_steps(contact_, options_)), travel_(options_.steps, options_.meshed_share < 1) {}

void MotionStepper::note_event(double time) {
  if (events_.empty() || events_.back() < time) {
    events_.push_back(time);
  }
}

bool MotionStepper::asked_for(double time) const {
  const double tolerance = instant_tolerance * std::abs(time);
  const auto next =
      std::lower_bound(options_.instants.begin(), options_.instants.end(), time - tolerance);
  return next != options_.instants.end() && *next <= time + tolerance;
}

/// Reports an instant to the sink.
/// @returns the height that was reported [m]
double MotionStepper::emit(const MotionLeg& leg, double fraction, std::optional<double> height,
                           bool required) {
  const double time = fraction == 1 ? leg.end() : leg.begin + fraction * leg.duration;
  const bool touches = contact_.in_contact();
  if (touches) {
    height = -contact_.state().indentation;
  }
  last_height_ = height.value_or(last_height_);
  StepPoint point{time,    leg.centre(fraction * leg.duration), last_height_,
                  touches, required || asked_for(time),         {}};
  if (touches) {
    point.centre = steps_->centre(leg, fraction);
    point.drive_force = steps_->drive_force(leg, fraction);
  }
  sink_(point, contact_);
  return last_height_;
}

/// True if the slider may touch along a leg. With adhesion this includes legs near the skin, and a
/// contact that still holds on.
bool MotionStepper::may_touch(const MotionLeg& leg) const {
  const auto near = [&](const SliderLevel& level) {
    return !level.is_force && level.value < contact_.range();
  };
  return leg.touches() || contact_.in_contact() || near(leg.from_level) || near(leg.to_level);
}

void MotionStepper::follow(const MotionLeg& leg) {
  if (may_touch(leg)) {
    touch(leg);
    return;
  }
  travel_.rest();
  emit(leg, 1, leg.to_level.is_force ? std::nullopt : std::optional(leg.to_level.value), false);
}

/// Number of steps of a touchdown. Under a flat slider the solution is proportional to the
/// indentation, if the friction limit is proportional to the pressure: a single step is exact.
int MotionStepper::touchdown_steps() const {
  const ContactProblem& problem = contact_.problem();
  const bool flat = std::ranges::all_of(problem.gap, [](double gap) { return gap == 0; });
  const bool proportional = flat && laws::is_proportional(problem.friction);
  return proportional && !contact_.in_contact() ? 1 : options_.steps.touchdown;
}

/// Notes an event where the slider sets off, halts, or begins to change its load, since that starts
/// a fresh transient.
void MotionStepper::note_change(const MotionLeg& leg, const LegLevels& levels) {
  const bool travels = leg.length() > 0 || leg.turns(), loads = levels.changes();
  if (contact_.in_contact() && (travels != travels_ || loads != loads_)) {
    note_event(leg.begin);
  }
  travels_ = travels;
  loads_ = loads;
}

/// Largest part of a leg in one step while the slider turns [1]. It limits the angle about z and,
/// where the slider tilts, how far its border rises and sinks.
double MotionStepper::share_of_turn(const MotionLeg& leg) const {
  if (!leg.turns()) {
    return 1;
  }
  const shapes::Pose &from = leg.from_pose, &to = leg.to_pose;
  const double tilt = std::max(std::abs(to.roll - from.roll), std::abs(to.pitch - from.pitch));
  const double rise = tilt * options_.half_diagonal, turn = std::abs(to.yaw - from.yaw);
  // A force gives no depth to compare with: the rise of the border then takes all steps.
  const double depth = options_.heaviest_indentation > 0 ? options_.heaviest_indentation : rise;
  return 1 / std::max({1.0, turn / options_.longest_turn,
                       turn * options_.half_diagonal / options_.longest_travel,
                       options_.steps.touchdown * rise / std::max(depth, 1e-30)});
}

double MotionStepper::next_fraction(const MotionLeg& leg, const LegLevels& levels,
                                    double at) const {
  double next = levels.end;
  if (const double travel = leg.length(); travel > 0) {
    const double onset =
        steps_->follows_path() ? travel_.longest() : std::numeric_limits<double>::infinity();
    next = std::min(next, at + std::min(onset, options_.longest_travel) / travel);
  }
  // With adhesion, a leg may have only pulls, or only heights above the skin.
  const double scale =
      levels.by_force
          ? std::max({options_.heaviest_force / options_.meshed_share, std::abs(levels.from),
                      std::abs(levels.to)})
          : std::max({options_.heaviest_indentation, contact_.range(), -levels.from, -levels.to});
  const int count = levels.presses() ? touchdown_steps() : options_.steps.lift_off;
  if (const double change = std::abs(levels.to - levels.from); change > 0) {
    next = std::min(next, at + scale / count / change);
  }
  next = std::min(next, at + share_of_turn(leg));
  if (rest_step_ > 0) {
    next = std::min(next, at + rest_step_ / leg.duration);
  }
  const double time = leg.begin + at * leg.duration;
  for (const std::vector<double>* instants : {&options_.instants, &options_.others}) {
    const auto instant =
        std::upper_bound(instants->begin(), instants->end(), time * (1 + instant_tolerance));
    if (instant != instants->end() && leg.duration > 0) {
      next = std::min(next, (*instant - leg.begin) / leg.duration);
    }
  }
  // No tiny step is left at the end.
  return next > levels.end - 1e-3 * (next - at) ? levels.end : next;
}

/// Brings the slider to the point of the leg where it may touch.
/// @returns true if it lands there
bool MotionStepper::lands_on_the_way(const MotionLeg& leg, const LegLevels& levels) {
  // A slider that lies on the skin at the start counts as landed from above, without slip.
  if (levels.begin > 0 || (contact_.range() == 0 && !contact_.in_contact())) {
    contact_.set_end_of_step(leg.begin + levels.begin * leg.duration);
    contact_.step(levels.begin * leg.duration, leg.centre(levels.begin * leg.duration),
                  {LoadKind::indentation, 0 - contact_.range()},
                  leg.pose(levels.begin * leg.duration));
  }
  if (levels.begin > 0) {
    emit(leg, levels.begin, contact_.range(), true);
  }
  if (contact_.in_contact()) {
    return false;
  }
  note_event(leg.begin + levels.begin * leg.duration);
  travel_.rest();
  steps_->land(leg, levels.begin);
  return true;
}

void MotionStepper::begin_travel(const MotionLeg& leg, bool lands, double begin) {
  if (lands) {
    travel_.pass(leg.direction()); // cells that come into contact slip at once: there is no onset
    return;
  }
  if (travel_.begin(leg, contact_) && !onset_open_) {
    onsets_.push_back({leg.begin, leg.begin});
    onset_open_ = true;
    note_event(leg.begin);
    emit(leg, begin, std::nullopt, true);
  }
}

void MotionStepper::touch(const MotionLeg& leg) {
  const bool known = steps_->follows_path() || !contact_.in_contact();
  const LegLevels levels =
      leg_levels(leg, contact_, known ? leg.to : contact_.place(), options_.meshed_share);
  note_change(leg, levels);
  const bool lands = lands_on_the_way(leg, levels);
  const bool rests =
      leg.length() == 0 && !leg.turns() && !levels.changes() && steps_->follows_path();
  if (leg.length() > 0) {
    begin_travel(leg, lands, levels.begin);
  } else {
    travel_.rest();
    onset_open_ = false;
  }
  if (rests && !contact_.problem().friction.rate_dependent && options_.others.empty()) {
    emit(leg, 1, levels.height(1), false); // nothing happens while the slider rests
    return;
  }
  if (!rests) {
    rest_step_ = 0;
  } else if (rest_step_ == 0) {
    rest_step_ = first_of_rest * leg.duration;
  }
  go(leg, levels);
}

void MotionStepper::go(const MotionLeg& leg, const LegLevels& levels) {
  bool touched = contact_.in_contact();
  const auto passed = [&](const PassedStep& step) {
    if (contact_.range() > 0 && touched != contact_.in_contact()) {
      note_event(leg.begin + step.fraction * leg.duration);
      touched = !touched;
    }
    return emit(leg, step.fraction, step.height,
                step.required || (step.fraction == levels.end && levels.leaves()));
  };
  for (double at = levels.begin; at < levels.end;) {
    base::check_interrupt();
    at = steps_->advance(leg, levels, at, next_fraction(leg, levels, at), passed);
    rest_step_ *= growth_of_rest;
    const double time = leg.begin + at * leg.duration;
    const bool lets_go = contact_.range() > 0 && !levels.presses() && !contact_.in_contact();
    const bool leaves = lets_go || (at == levels.end && levels.leaves());
    if (onset_open_) {
      onsets_.back()[1] = time;
      // The path does not give the speed of a slider on a drive.
      const bool over =
          steps_->follows_path() ? travel_.is_over(leg, contact_) : !contact_.sticks();
      onset_open_ = !leaves && !over;
    }
    if (leg.length() > 0) {
      travel_.grow(contact_);
    }
    if (leaves) {
      note_event(time);
      travel_.rest();
    }
    if (lets_go) {
      emit(leg, 1, levels.height(1), false);
      return;
    }
  }
  if (levels.leaves()) {
    if (contact_.in_contact()) { // other sliders lift the skin above its undeformed face
      contact_.set_end_of_step(leg.end());
      contact_.step((1 - levels.end) * leg.duration, leg.to, levels.load(1), leg.to_pose);
    }
    emit(leg, 1, levels.to, false);
  }
}

} // namespace ionskin::mechanics
