// SPDX-License-Identifier: Apache-2.0
#include "ionskin/handover/contact_timeline.hpp"

#include <algorithm>

namespace ionskin::handover {

void StateCombination::add(const mechanics::SharedState& state, double weight) {
  // A slider held by adhesion may be above the height at which it landed.
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

double StateCombination::peak_pressure() const {
  std::vector<double> pressure;
  for (const Term& term : terms) {
    pressure.resize(term.state->normal_traction.size());
    for (std::size_t cell = 0; cell < pressure.size(); ++cell) {
      pressure[cell] += term.weight * term.state->normal_traction[cell];
    }
  }
  return pressure.empty() ? 0.0 : std::ranges::max(pressure);
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

std::array<double, 3> StateCombination::moment() const {
  std::array<double, 3> moment{};
  for (const Term& term : terms) {
    for (std::size_t d = 0; d < moment.size(); ++d) {
      moment[d] += term.weight * term.state->moment[d];
    }
  }
  return moment;
}

ContactTimeline::ContactTimeline(const Case& input, const mechanics::ContactSolution& contact)
    : contact_(contact),
      begin_of_slide_(first_slide(motion_legs(input.motion, input.slider)).begin) {
  for (const mechanics::SteppedInstant& instant : contact_.stepped) {
    sample_times_.push_back(instant.time);
  }
}

StateCombination ContactTimeline::at(double local_time) const {
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
  if (from.turned && to.turned) {
    result.turned = *from.turned;
    for (std::size_t cell = 0; cell < result.turned.size(); ++cell) {
      for (std::size_t c = 0; c < 3; ++c) {
        result.turned[cell][c] += weight * ((*to.turned)[cell][c] - result.turned[cell][c]);
      }
    }
  }
  return result;
}

double ContactTimeline::join_time() const {
  return contact_.stepped_onsets.empty() ? begin_of_slide_ : contact_.stepped_onsets.front()[1];
}

} // namespace ionskin::handover
