// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/engine/motion_stepper.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/base/system/interrupt.hpp"
#include "ionskin/mechanics/surface/adhesion_energy.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace ionskin::mechanics {
namespace {

/// Of the surface's displacement in full slip: with less than this left, nothing sticks any more.
constexpr double negligible_onset = 1e-6;
/// With less than this left, the onset is over.
constexpr double end_of_onset = 1e-2;
/// Behind an onset steps lengthen faster.
constexpr double growth_of_full_slip = 1.3;
/// A row shorter than the onset is cut into at most so many steps.
constexpr int most_cuts_of_short_leg = 8;
/// A step without a solution is halved so often before the motion is given up.
constexpr int most_halvings = 6;
/// Of the rest of a slider, while friction that depends on rate relaxes: first step over its
/// duration, and growth of the steps.
constexpr double first_of_rest = 1.0 / 1024, growth_of_rest = 1.5;
/// A step that may have jumped is halved so often, to find where.
constexpr int halvings_of_jump = 8;
constexpr double instant_tolerance = 1e-12; // of the time itself

} // namespace

/// Fractions of the leg between which the slider touches, and its level there.
struct MotionStepper::Levels {
  double begin = 0, end = 1;
  bool by_force = false;   ///< all along
  double from = 0, to = 0; ///< force of the whole skin [N], or height at the ends of the leg [m]
  std::optional<double> at_end; ///< force that the leg ends with though it goes by height [N]

  double at(double fraction) const { return fraction == 1 ? to : from + fraction * (to - from); }
};

MotionStepper::MotionStepper(SlidingContact& contact, StepperOptions options, Sink sink)
    : contact_(contact), options_(std::move(options)), sink_(std::move(sink)) {
  if (options_.drive) {
    driven_.emplace(contact_, *options_.drive, options_.meshed_share);
  }
}

MotionStepper::Levels MotionStepper::levels(const MotionLeg& leg) const {
  Levels levels;
  levels.by_force = leg.from_level.is_force && leg.to_level.is_force;
  if (levels.by_force) {
    levels.from = leg.from_level.value;
    levels.to = leg.to_level.value;
    return levels;
  }
  const double off = contact_.in_contact() ? -contact_.state().indentation : range();
  levels.from = leg.from_level.is_force ? off : leg.from_level.value;
  levels.to = leg.to_level.value;
  if (leg.to_level.is_force) {
    // The height at which the force will be carried: tried out, then taken back.
    SlidingContact trial = contact_;
    levels.at_end = leg.to_level.value;
    levels.to = -trial
                     .step(leg.duration, driven_ && trial.in_contact() ? trial.place() : leg.to,
                           {LoadKind::force, leg.to_level.value * options_.meshed_share})
                     .indentation;
  }
  const bool adheres = range() > 0;
  if (levels.from > range() && !(adheres && contact_.in_contact())) {
    levels.begin = (levels.from - range()) / (levels.from - levels.to);
  }
  if (levels.to > 0 && !adheres) {
    levels.end = levels.from / (levels.from - levels.to);
  }
  return levels;
}

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

void MotionStepper::emit(const MotionLeg& leg, double fraction, double height, bool required) {
  const double time = fraction == 1 ? leg.end() : leg.begin + fraction * leg.duration;
  const bool touches = contact_.in_contact();
  StepPoint point{time,
                  leg.centre(fraction * leg.duration),
                  touches ? -contact_.state().indentation : height,
                  touches,
                  required || asked_for(time),
                  {}};
  last_height_ = point.height;
  if (driven_ && touches) {
    point.centre = contact_.place();
    point.drive_force = driven_->force(leg, fraction);
  }
  sink_(point, contact_);
}

/// With adhesion also near the skin, and wherever it still holds on.
bool MotionStepper::may_touch(const MotionLeg& leg) const {
  const auto near = [&](const SliderLevel& level) {
    return !level.is_force && level.value < range();
  };
  return leg.touches() || contact_.in_contact() || near(leg.from_level) || near(leg.to_level);
}

void MotionStepper::follow(const MotionLeg& leg) {
  if (!may_touch(leg)) {
    direction_ = {};
    emit(leg, 1, leg.to_level.is_force ? last_height_ : leg.to_level.value, false);
    return;
  }
  touch(leg);
}

void MotionStepper::begin_travel(const MotionLeg& leg) {
  const auto direction = leg.direction();
  const double turn =
      std::acos(std::clamp(direction[0] * direction_[0] + direction[1] * direction_[1], -1.0, 1.0));
  const bool goes_on = direction_ != std::array<double, 2>{} && turn <= sharp_turn;
  direction_ = direction;
  if (goes_on) {
    return;
  }
  const auto distance =
      contact_.onset_distance(direction, options_.meshed_share < 1, leg.length(), leg.duration);
  const double whole = options_.steps.onset_travel_ratio * distance.left;
  if (distance.left <= negligible_onset * distance.whole) {
    increment_ = std::numeric_limits<double>::infinity();
    return;
  }
  const double total = (std::pow(options_.steps.onset_growth, options_.steps.onset) - 1) /
                       (options_.steps.onset_growth - 1); // of all increments over the first
  increment_ = whole / total;
  if (leg.length() < distance.left) {
    increment_ = std::max(increment_, leg.length() / most_cuts_of_short_leg);
  }
  if (!onset_open_) {
    onsets_.push_back({leg.begin, leg.begin});
    onset_open_ = true;
    note_event(leg.begin);
  }
}

bool MotionStepper::slides_fully(const MotionLeg& leg) const {
  if (driven_ || contact_.sticks()) {
    return !contact_.sticks(); // how fast a driven slider goes is not the path's to say
  }
  const auto distance =
      contact_.onset_distance(direction_, options_.meshed_share < 1, leg.length(), leg.duration);
  return distance.left <= end_of_onset * distance.whole;
}

/// From no load the problem of a flat slider is homogeneous in the indentation where the limit of
/// friction is in proportion to the pressure: one step is exact.
int MotionStepper::touchdown_steps() const {
  const ContactProblem& problem = contact_.problem();
  const bool flat = std::ranges::all_of(problem.gap, [](double gap) { return gap == 0; });
  const bool proportional =
      !problem.friction.rate_dependent && problem.friction.elastic_slip == 0 &&
      2 * problem.friction_limit(0, 1, 0, 0) == problem.friction_limit(0, 2, 0, 0);
  return flat && proportional && !contact_.in_contact() ? 1 : options_.steps.touchdown;
}

/// A slider that sets off, halts, or begins to change its load starts a fresh transient.
void MotionStepper::note_change(const MotionLeg& leg, const Levels& levels) {
  const bool travels = leg.length() > 0, loads = levels.from != levels.to;
  if (contact_.in_contact() && (travels != travels_ || loads != loads_)) {
    note_event(leg.begin);
  }
  travels_ = travels;
  loads_ = loads;
}

double MotionStepper::next_fraction(const MotionLeg& leg, const Levels& levels, double at) const {
  double next = levels.end;
  if (const double travel = leg.length(); travel > 0) {
    next = std::min(next, at + std::min(increment_, options_.longest_travel) / travel);
  }
  // A slider that adhesion holds may go by pulls, or by heights above the skin, alone.
  const double scale =
      levels.by_force
          ? std::max({options_.heaviest_force / options_.meshed_share, std::abs(levels.from),
                      std::abs(levels.to)})
          : std::max({options_.heaviest_indentation, range(), -levels.from, -levels.to});
  const bool loads = levels.by_force ? levels.to > levels.from : levels.to < levels.from;
  const int count = loads ? touchdown_steps() : options_.steps.lift_off;
  if (const double change = std::abs(levels.to - levels.from); change > 0) {
    next = std::min(next, at + scale / count / change);
  }
  if (rest_step_ > 0) {
    next = std::min(next, at + rest_step_ / leg.duration);
  }
  const double time = leg.begin + at * leg.duration;
  const auto instant = std::upper_bound(options_.instants.begin(), options_.instants.end(),
                                        time * (1 + instant_tolerance));
  if (instant != options_.instants.end() && leg.duration > 0) {
    next = std::min(next, (*instant - leg.begin) / leg.duration);
  }
  // No sliver is left behind.
  return next > levels.end - 1e-3 * (next - at) ? levels.end : next;
}

SliderLoad MotionStepper::load_at(const Levels& levels, double fraction) const {
  if (levels.by_force) {
    return {LoadKind::force, levels.at(fraction) * options_.meshed_share};
  }
  if (fraction == 1 && levels.at_end) {
    return {LoadKind::force, *levels.at_end * options_.meshed_share};
  }
  // Where it leaves no rounding must hold it back.
  return {LoadKind::indentation,
          fraction == levels.end && levels.end < 1 ? 0.0 : -levels.at(fraction)};
}

void MotionStepper::advance(const MotionLeg& leg, const Levels& levels, double from, double to,
                            int depth) {
  try {
    contact_.step((to - from) * leg.duration, leg.centre(to * leg.duration), load_at(levels, to));
    ++steps_taken_;
  } catch (const SolverError&) {
    if (depth == most_halvings) {
      throw;
    }
    advance(leg, levels, from, 0.5 * (from + to), depth + 1);
    advance(leg, levels, 0.5 * (from + to), to, depth + 1);
  }
}

/// Shortens the steps where the contact jumps; what is passed is emitted here.
void MotionStepper::advance_adhering(const MotionLeg& leg, const Levels& levels, double from,
                                     double to, int depth) {
  // A slider that a force moves stands where the skin carries it, or where it let go.
  const auto height = [&](double fraction) {
    if (!levels.by_force) {
      return levels.at(fraction);
    }
    return contact_.in_contact() ? -contact_.state().indentation : last_height_;
  };
  const bool shortest = depth == halvings_of_jump;
  if (shortest) {
    emit(leg, from, height(from), true); // before what may be a jump
  }
  const SlidingContact::Moment before = contact_.moment();
  const double energy = contact_.energy(), height_before = height(from);
  const bool touched = contact_.in_contact();
  bool solved = false;
  try {
    contact_.step((to - from) * leg.duration, leg.centre(to * leg.duration), load_at(levels, to));
    solved = true;
  } catch (const SolverError&) {
    if (shortest) {
      throw;
    }
  }
  if (!shortest && (!solved || contact_.may_have_jumped())) {
    contact_.go_back(before);
    advance_adhering(leg, levels, from, 0.5 * (from + to), depth + 1);
    advance_adhering(leg, levels, 0.5 * (from + to), to, depth + 1);
    return;
  }
  ++steps_taken_;
  const bool jumps = contact_.may_have_jumped();
  if (jumps) {
    adhesion_loss_ += work_on_skin(before.state, contact_.state(), height_before - height(to)) -
                      (contact_.energy() - energy);
  }
  if (touched != contact_.in_contact()) {
    note_event(leg.begin + to * leg.duration);
  }
  emit(leg, to, height(to), jumps);
}

void MotionStepper::touch(const MotionLeg& leg) {
  const Levels levels = this->levels(leg);
  note_change(leg, levels);
  const double travel = leg.length();
  if (levels.begin > 0) {
    contact_.step(levels.begin * leg.duration, leg.centre(levels.begin * leg.duration),
                  {LoadKind::indentation, 0 - range()});
    emit(leg, levels.begin, range(), true);
  }
  const bool lands = !contact_.in_contact();
  if (lands) {
    note_event(leg.begin + levels.begin * leg.duration);
    direction_ = {};
  }
  if (travel == 0) {
    direction_ = {};
    onset_open_ = false;
    if (levels.from == levels.to && !contact_.problem().friction.rate_dependent && !driven_) {
      emit(leg, 1, levels.to, false); // nothing happens while the slider rests
      return;
    }
  } else if (!lands) {
    begin_travel(leg);
  } else {
    // Whatever touches on the way slips from the first.
    direction_ = leg.direction();
    increment_ = std::numeric_limits<double>::infinity();
  }
  if (driven_) { // steps find their length themselves
    increment_ = std::numeric_limits<double>::infinity();
    if (lands) {
      driven_->hold(leg, levels.begin);
    }
  }
  const bool rests = travel == 0 && levels.from == levels.to && !driven_;
  if (!rests) {
    rest_step_ = 0;
  } else if (rest_step_ == 0) {
    rest_step_ = first_of_rest * leg.duration;
  }
  double at = levels.begin;
  bool first_of_travel = travel > 0 && onset_open_ && onsets_.back()[0] == leg.begin;
  while (at < levels.end) {
    base::check_interrupt();
    if (first_of_travel) {
      emit(leg, at, -contact_.state().indentation, true);
      first_of_travel = false;
    }
    const double next = next_fraction(leg, levels, at);
    if (range() > 0) {
      advance_adhering(leg, levels, at, next, 0);
      at = next;
    } else if (driven_) {
      at = driven_->advance(leg, at, next,
                            [&](double fraction) { return load_at(levels, fraction); });
      ++steps_taken_;
    } else {
      advance(leg, levels, at, next, 0);
      at = next;
    }
    rest_step_ *= growth_of_rest;
    const double time = leg.begin + at * leg.duration;
    const bool rises = levels.by_force ? levels.to <= levels.from : levels.to >= levels.from;
    const bool lets_go = range() > 0 && rises && !contact_.in_contact();
    const bool leaves = lets_go || (at == levels.end && levels.end < 1);
    if (onset_open_) {
      onsets_.back()[1] = time;
      onset_open_ = !leaves && !slides_fully(leg);
    }
    if (travel > 0) {
      increment_ *= contact_.sticks() ? options_.steps.onset_growth : growth_of_full_slip;
    }
    if (range() == 0) {
      emit(leg, at, levels.by_force ? 0 : levels.at(at), leaves);
    }
    if (leaves) {
      note_event(time);
      direction_ = {};
    }
    if (lets_go) {
      emit(leg, 1, levels.by_force ? last_height_ : levels.to, false);
      return;
    }
  }
  if (levels.end < 1) {
    emit(leg, 1, levels.to, false);
  }
}

} // namespace ionskin::mechanics
