// SPDX-License-Identifier: Apache-2.0
#include "ionskin/strain/contact_timeline.hpp"

#include <algorithm>
#include <cmath>

namespace ionskin::strain {
namespace {

using mechanics::PathState;

/// Samples of steady sliding over the whole stroke.
int slide_samples(const Numerics& numerics) {
  int samples = 40;
  if (numerics.preset == Preset::coarse) {
    samples = 20;
  } else if (numerics.preset == Preset::fine) {
    samples = 80;
  }
  return static_cast<int>(std::ceil(samples * numerics.time_refinement));
}

/// Weights of polynomial interpolation through the nodes at x.
std::vector<double> lagrange_weights(const std::vector<PathState>& nodes, double x) {
  std::vector<double> weights(nodes.size(), 1.0);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    for (std::size_t j = 0; j < nodes.size(); ++j) {
      if (i != j) {
        weights[i] *= (x - nodes[j].parameter) / (nodes[i].parameter - nodes[j].parameter);
      }
    }
  }
  return weights;
}

void add_term(StateCombination& combination, const mechanics::ContactState& state, double weight) {
  if (weight != 0) {
    combination.terms.push_back({&state, weight});
  }
}

} // namespace

double StateCombination::normal_force() const {
  double force = 0;
  for (const Term& term : terms) {
    force += term.weight * term.state->normal_force;
  }
  return force;
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
    : input_(input), contact_(contact) {
  const Motion& motion = input.motion;
  const double approach = motion.gap / (motion.gap + motion.preload);
  contact_time_ = motion.touchdown * approach;
  const double slide_start = motion.touchdown;
  const double lift_start = slide_start + motion.slide;
  release_time_ = lift_start + motion.lift * (1 - approach);

  event_times_ = {contact_time_, slide_start, lift_start, release_time_};
  sample_times_ = {0.0, contact_time_, slide_start};
  join_time_ = slide_start;
  const double speed = motion.stroke / motion.slide;
  for (const PathState& state : contact.onset) {
    sample_times_.push_back(slide_start + state.parameter / speed);
  }
  if (contact.steady.empty() && !contact.onset.empty()) {
    join_time_ = lift_start;
  }
  if (!contact.steady.empty()) {
    if (contact.onset.size() > 1) {
      const double last = contact.onset.back().parameter;
      join_travel_ = 2 * last - contact.onset[contact.onset.size() - 2].parameter;
      join_time_ = slide_start + join_travel_ / speed;
      sample_times_.push_back(join_time_);
    }
    // Spacing grows from the last onset interval to the regular one.
    const double regular = motion.slide / slide_samples(input.numerics);
    double step = sample_times_.back() - sample_times_[sample_times_.size() - 2];
    double time = sample_times_.back();
    for (step *= 1.5; step < regular && time + 2 * step < lift_start; step *= 1.5) {
      time += step;
      sample_times_.push_back(time);
    }
    const int remaining = std::max(1, static_cast<int>(std::ceil((lift_start - time) / regular)));
    for (int i = 1; i < remaining; ++i) {
      sample_times_.push_back(time + (lift_start - time) * i / remaining);
    }
  }
  sample_times_.push_back(lift_start);
  for (const PathState& state : contact.lift_off) {
    sample_times_.push_back(lift_start + (release_time_ - lift_start) * (1 - state.parameter));
  }
  sample_times_.push_back(release_time_);
  sample_times_.push_back(lift_start + motion.lift);
  sample_times_.push_back(motion.cycle_duration());
  add_requested_instants();
  // Coinciding instants (no gap, last lift-off state at zero preload) count once.
  const auto coincide = [&](double a, double b) { return b - a < 1e-12 * motion.cycle_duration(); };
  sample_times_.erase(std::unique(sample_times_.begin(), sample_times_.end(), coincide),
                      sample_times_.end());
}

void ContactTimeline::add_requested_instants() {
  const Motion& motion = input_.motion;
  std::vector<double> instants{motion.touchdown + 0.5 * motion.slide};
  for (const double instant : input_.output.fields) {
    instants.push_back(std::fmod(instant, motion.cycle_duration()));
  }
  for (const double instant : instants) {
    const bool steady = instant > join_time_ && instant < motion.touchdown + motion.slide;
    if (steady && !contact_.steady.empty()) {
      sample_times_.push_back(instant);
    }
  }
  std::sort(sample_times_.begin(), sample_times_.end());
}

void ContactTimeline::add_onset(StateCombination& combination, double travel) const {
  double before = 0;
  const mechanics::ContactState* state_before = &contact_.touchdown.state;
  for (const PathState& node : contact_.onset) {
    if (node.parameter > travel) {
      const double weight = (travel - before) / (node.parameter - before);
      add_term(combination, *state_before, 1 - weight);
      add_term(combination, node.state, weight);
      return;
    }
    before = node.parameter;
    state_before = &node.state;
  }
  if (contact_.steady.empty()) {
    add_term(combination, *state_before, 1.0);
    return;
  }
  const double weight = (travel - before) / (join_travel_ - before);
  add_term(combination, *state_before, 1 - weight);
  add_term(combination, contact_.steady.front().state, weight);
}

StateCombination ContactTimeline::sliding(double travel) const {
  StateCombination result;
  result.arc_length = travel;
  if (contact_.steady.empty()) {
    add_onset(result, travel);
    return result;
  }
  const auto weights = lagrange_weights(contact_.steady, travel);
  for (std::size_t i = 0; i < weights.size(); ++i) {
    add_term(result, contact_.steady[i].state, weights[i]);
  }
  if (travel < join_travel_) {
    add_onset(result, travel);
    add_term(result, contact_.steady.front().state, -1.0);
  }
  return result;
}

const mechanics::ContactState& ContactTimeline::end_of_slide() const {
  if (!contact_.steady.empty()) {
    return contact_.steady.back().state;
  }
  return contact_.onset.empty() ? contact_.touchdown.state : contact_.onset.back().state;
}

StateCombination ContactTimeline::lifting(double fraction) const {
  StateCombination result;
  result.arc_length = input_.motion.stroke;
  double above = 1;
  const mechanics::ContactState* state_above = &end_of_slide();
  for (const PathState& node : contact_.lift_off) {
    if (node.parameter < fraction) {
      const double weight = (above - fraction) / (above - node.parameter);
      add_term(result, *state_above, 1 - weight);
      if (node.parameter > 0) {
        add_term(result, node.state, weight);
      }
      return result;
    }
    above = node.parameter;
    state_above = &node.state;
  }
  add_term(result, *state_above, fraction / above);
  return result;
}

StateCombination ContactTimeline::at(double local_time) const {
  const Motion& motion = input_.motion;
  const double slide_start = motion.touchdown;
  const double lift_start = slide_start + motion.slide;
  StateCombination result;
  if (local_time <= contact_time_) {
    return result;
  }
  if (local_time <= slide_start) {
    add_term(result, contact_.touchdown.state,
             (local_time - contact_time_) / (slide_start - contact_time_));
    return result;
  }
  if (local_time <= lift_start) {
    return sliding(motion.stroke * std::min(1.0, (local_time - slide_start) / motion.slide));
  }
  if (local_time < release_time_) {
    return lifting((release_time_ - local_time) / (release_time_ - lift_start));
  }
  const double return_start = lift_start + motion.lift;
  result.arc_length = motion.stroke;
  if (local_time > return_start) {
    result.arc_length *= std::max(0.0, 1 - (local_time - return_start) / motion.return_);
  }
  return result;
}

} // namespace ionskin::strain
