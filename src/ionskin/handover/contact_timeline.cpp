// SPDX-License-Identifier: Apache-2.0
#include "ionskin/handover/contact_timeline.hpp"

#include "ionskin/history/samples_per_slide.hpp"
#include "ionskin/mechanics/position/interpolation_nodes.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace ionskin::handover {
namespace {

using mechanics::LegSolution;
using mechanics::PathState;

/// Regular distance of samples in steady sliding; short slides, which fewer nodes describe, need
/// fewer [s].
double regular_step(const Case& input, const MotionLeg& motion) {
  const auto intervals = [&](const std::array<double, 2>& from, const std::array<double, 2>& to) {
    return static_cast<double>(mechanics::expected_node_count(input, from, to) - 1);
  };
  const ContactPart part = contact_part(motion);
  const double share = intervals(part.from, part.to) / intervals({0, 0}, {input.skin.length, 0});
  return motion.duration / std::ceil(history::samples_per_slide(input.numerics) * share);
}

double contact_begin(const LegSolution& leg) {
  return leg.path.empty() ? leg.steady.front().time : leg.path.front().time;
}

double contact_end(const LegSolution& leg) {
  return leg.steady.empty() ? leg.path.back().time : leg.steady.back().time;
}

/// Between which states of the path an instant lies: (1 - weight) of `index`, weight of the next.
struct PathPlace {
  std::size_t index = 0;
  double weight = 0;
};

PathPlace place_on(const std::vector<PathState>& path, double time) {
  std::size_t next = 1;
  while (next < path.size() && path[next].time <= time) {
    ++next;
  }
  if (next == path.size()) {
    return {next - 1, 0};
  }
  const double before = path[next - 1].time;
  return {next - 1, std::max(0.0, (time - before) / (path[next].time - before))};
}

void add_path(const LegSolution& leg, double time, StateCombination& combination) {
  const PathPlace place = place_on(leg.path, time);
  combination.add(leg.path[place.index].state, 1 - place.weight);
  if (place.weight > 0) {
    combination.add(leg.path[place.index + 1].state, place.weight);
  }
}

/// The deviation of the path from steady sliding.
void add_deviation(const LegSolution& leg, double time, StateCombination& combination) {
  const auto add = [&](std::size_t index, double weight) {
    combination.add(leg.path[index].state, weight);
    combination.add(leg.reference[index], -weight);
  };
  const double last = leg.path.back().time;
  if (time >= last) {
    add(leg.path.size() - 1, (leg.joined - time) / (leg.joined - last));
    return;
  }
  const PathPlace place = place_on(leg.path, time);
  add(place.index, 1 - place.weight);
  add(place.index + 1, place.weight);
}

} // namespace

void StateCombination::add(const mechanics::SharedState& state, double weight) {
  // Adhesion holds it above the height at which it landed.
  const bool loaded = state && (state->indentation > 0 || state->normal_force < 0);
  if (!loaded || weight == 0) {
    return;
  }
  const auto same = std::find_if(terms.begin(), terms.end(),
                                 [&](const Term& term) { return term.state == state.get(); });
  if (same == terms.end()) {
    terms.push_back({state.get(), weight});
  } else {
    same->weight += weight;
  }
}

double StateCombination::sum(double mechanics::ContactState::*quantity) const {
  double result = 0;
  for (const Term& term : terms) {
    result += term.weight * term.state->*quantity;
  }
  return result;
}

double StateCombination::normal_force() const {
  return sum(&mechanics::ContactState::normal_force);
}

double StateCombination::contact_area() const {
  return sum(&mechanics::ContactState::contact_area);
}

double StateCombination::stick_area() const {
  return sum(&mechanics::ContactState::stick_area);
}

double StateCombination::contact_border() const {
  return sum(&mechanics::ContactState::contact_border);
}

std::array<double, 2> StateCombination::tangential_force() const {
  std::array<double, 2> force{};
  for (const Term& term : terms) {
    force[0] += term.weight * term.state->tangential_force[0];
    force[1] += term.weight * term.state->tangential_force[1];
  }
  return force;
}

ContactTimeline::ContactTimeline(const Case& input, const mechanics::ContactSolution& contact)
    : contact_(contact), legs_(motion_legs(input.motion, input.slider)),
      duration_(legs_.back().end()) {
  if (!contact_.stepped.empty()) {
    for (const mechanics::SteppedInstant& instant : contact_.stepped) {
      sample_times_.push_back(instant.time);
    }
    event_times_ = contact_.stepped_events;
    return;
  }
  add_sample(0, 0.0);
  for (std::size_t i = 0; i < legs_.size(); ++i) {
    add_leg_samples(input, i);
    const LegSolution& leg = contact_.legs[i];
    if (!leg.in_contact()) {
      continue;
    }
    event_times_.push_back(legs_[i].begin + (legs_[i].lands() ? contact_begin(leg) : 0.0));
    if (legs_[i].leaves()) {
      event_times_.push_back(legs_[i].begin + contact_end(leg));
    }
  }
  add_requested_instants(input.output.fields);
  sort_samples();
}

void ContactTimeline::add_sample(std::size_t leg, double since_begin) {
  samples_.push_back({leg, since_begin});
}

void ContactTimeline::add_leg_samples(const Case& input, std::size_t index) {
  const LegSolution& leg = contact_.legs[index];
  const double duration = legs_[index].duration;
  for (const PathState& point : leg.path) {
    add_sample(index, point.time);
  }
  if (!leg.steady.empty()) {
    add_sample(index, contact_begin(leg));
    double time = leg.joined;
    const double end = contact_end(leg), regular = regular_step(input, legs_[index]);
    if (!leg.path.empty()) {
      add_sample(index, time);
      // Spacing grows from the last onset interval to the regular one.
      for (double step = 1.5 * (time - leg.path.back().time);
           step < regular && time + 2 * step < end; step *= 1.5) {
        time += step;
        add_sample(index, time);
      }
    }
    const int remaining = std::max(1, static_cast<int>(std::ceil((end - time) / regular)));
    for (int i = 1; i < remaining; ++i) {
      add_sample(index, time + (end - time) * i / remaining);
    }
    add_sample(index, end);
  }
  add_sample(index, duration);
}

void ContactTimeline::add_requested_instants(const std::vector<double>& fields) {
  const MotionLeg& slide = first_slide(legs_);
  std::vector<double> instants{slide.begin + 0.5 * slide.duration};
  for (const double instant : fields) {
    instants.push_back(std::fmod(instant, duration_));
  }
  for (const double instant : instants) {
    const std::size_t leg = leg_at(instant);
    const LegSolution& contact = contact_.legs[leg];
    const double since_begin = instant - legs_[leg].begin;
    if (!contact.steady.empty() && since_begin > contact.joined &&
        since_begin < contact_end(contact)) {
      add_sample(leg, since_begin);
    }
  }
}

void ContactTimeline::sort_samples() {
  const auto time = [&](const Sample& sample) {
    return legs_[sample.leg].begin + sample.since_begin;
  };
  std::stable_sort(samples_.begin(), samples_.end(),
                   [&](const Sample& a, const Sample& b) { return time(a) < time(b); });
  // Coinciding instants (no gap, the end of a leg and the begin of the next) count once.
  samples_.erase(std::unique(samples_.begin(), samples_.end(),
                             [&](const Sample& a, const Sample& b) {
                               return time(b) - time(a) < 1e-12 * duration_;
                             }),
                 samples_.end());
  for (const Sample& sample : samples_) {
    sample_times_.push_back(time(sample));
  }
}

std::size_t ContactTimeline::leg_at(double local_time) const {
  std::size_t leg = 0;
  while (leg + 1 < legs_.size() && local_time > legs_[leg].end()) {
    ++leg;
  }
  return leg;
}

StateCombination ContactTimeline::between_steps(double local_time) const {
  const auto after =
      std::upper_bound(sample_times_.begin() + 1, sample_times_.end() - 1, local_time);
  const auto next = static_cast<std::size_t>(after - sample_times_.begin());
  const mechanics::SteppedInstant &from = contact_.stepped[next - 1], &to = contact_.stepped[next];
  const double weight = std::clamp((local_time - from.time) / (to.time - from.time), 0.0, 1.0);
  StateCombination result;
  result.add(from.state, 1 - weight);
  result.add(to.state, weight);
  for (const std::size_t d : {0, 1}) {
    result.centre[d] = from.centre[d] + weight * (to.centre[d] - from.centre[d]);
    result.drive_force[d] =
        from.drive_force[d] + weight * (to.drive_force[d] - from.drive_force[d]);
  }
  result.height = from.height + weight * (to.height - from.height);
  return result;
}

StateCombination ContactTimeline::at(double local_time) const {
  if (!contact_.stepped.empty()) {
    return between_steps(local_time);
  }
  const std::size_t leg = leg_at(local_time);
  return combination(leg, local_time - legs_[leg].begin);
}

StateCombination ContactTimeline::at_sample(std::size_t index) const {
  if (!contact_.stepped.empty()) {
    return between_steps(sample_times_[index]);
  }
  return combination(samples_[index].leg, samples_[index].since_begin);
}

StateCombination ContactTimeline::combination(std::size_t index, double since_begin) const {
  const LegSolution& leg = contact_.legs[index];
  const MotionLeg& motion = legs_[index];
  StateCombination result;
  result.centre = motion.centre(since_begin);
  const bool detached = !leg.in_contact() ||
                        (motion.lands() && since_begin <= contact_begin(leg)) ||
                        (motion.leaves() && since_begin >= contact_end(leg));
  if (!detached && leg.steady.empty()) {
    add_path(leg, since_begin, result);
  } else if (!detached) {
    const auto weights = mechanics::interpolation_weights(leg.steady, since_begin);
    for (std::size_t i = 0; i < weights.size(); ++i) {
      result.add(leg.steady[i].state, weights[i]);
    }
    if (!leg.path.empty() && since_begin < leg.joined) {
      add_deviation(leg, since_begin, result);
    }
  }
  result.height = height(index, since_begin, result);
  return result;
}

double ContactTimeline::height(std::size_t index, double since_begin,
                               const StateCombination& combination) const {
  const MotionLeg& motion = legs_[index];
  if (motion.from_level.is_force && motion.to_level.is_force) {
    return -std::accumulate(combination.terms.begin(), combination.terms.end(), 0.0,
                            [](double sum, const StateCombination::Term& term) {
                              return sum + term.weight * term.state->indentation;
                            });
  }
  const auto& path = contact_.legs[index].path;
  const double from =
      motion.from_level.is_force ? -path.front().state->indentation : motion.from_level.value;
  const double to =
      motion.to_level.is_force ? -path.back().state->indentation : motion.to_level.value;
  return from + (to - from) * since_begin / motion.duration;
}

double ContactTimeline::joined_at(std::size_t index) const {
  const LegSolution& leg = contact_.legs[index];
  const MotionLeg& motion = legs_[index];
  if (!motion.slides()) {
    return motion.begin;
  }
  return leg.steady.empty() ? motion.end() : motion.begin + leg.joined;
}

double ContactTimeline::join_time() const {
  if (!contact_.stepped.empty()) {
    return contact_.stepped_onsets.empty() ? first_slide(legs_).begin
                                           : contact_.stepped_onsets.front()[1];
  }
  return joined_at(static_cast<std::size_t>(&first_slide(legs_) - legs_.data()));
}

std::vector<std::array<double, 2>> ContactTimeline::onsets() const {
  if (!contact_.stepped.empty()) {
    return contact_.stepped_onsets;
  }
  std::vector<std::array<double, 2>> result;
  for (std::size_t leg = 0; leg < legs_.size(); ++leg) {
    if (legs_[leg].slides()) {
      result.push_back({legs_[leg].begin, joined_at(leg)});
    }
  }
  return result;
}

} // namespace ionskin::handover
