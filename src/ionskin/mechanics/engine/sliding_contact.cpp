// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/engine/sliding_contact.hpp"

#include "ionskin/mechanics/surface/contact_diagnostics.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ionskin::mechanics {
namespace {

bool is_loaded(const CellVector& force) {
  return std::any_of(force.begin(), force.end(), [](double value) { return value != 0; });
}

} // namespace

SlidingContact::SlidingContact(const ComplianceMap& map, std::vector<double> area,
                               std::vector<double> gap, const laws::Friction& friction)
    : map_(map), problem_{{}, std::move(area), std::move(gap), friction} {
  state_.force.assign(3 * problem_.area.size(), 0.0);
  state_.surface = state_.force;
  state_.slip.assign(problem_.area.size(), 0.0);
}

bool SlidingContact::in_contact() const {
  return is_loaded(state_.force);
}

bool SlidingContact::sticks() const {
  return stick_fraction(problem_, state_.force) > 0;
}

void SlidingContact::detach(const SliderStep& step) {
  std::fill(state_.force.begin(), state_.force.end(), 0.0);
  std::fill(state_.surface.begin(), state_.surface.end(), 0.0);
  std::fill(state_.slip.begin(), state_.slip.end(), 0.0);
  const double first_touch = *std::min_element(problem_.gap.begin(), problem_.gap.end());
  state_.indentation =
      step.load.kind == LoadKind::force ? first_touch : std::max(0.0, step.load.value);
  state_.step = step;
  state_.iterations = 0;
}

const SurfaceState& SlidingContact::step(double time_step, const std::array<double, 2>& place,
                                         const SliderLoad& load) {
  const std::array<double, 2> from = place_.value_or(place);
  SliderStep step{load, {place[0] - from[0], place[1] - from[1]}, time_step, state_.surface};
  if (!place_ || place != from) {
    map_.at(place, problem_.compliance);
  }
  const double reach = load.kind == LoadKind::force
                           ? 0
                           : *std::min_element(problem_.gap.begin(), problem_.gap.end());
  if (load.value <= reach) {
    detach(step);
    place_ = place;
    return state_;
  }
  Iterate iterate{state_.force, state_.indentation};
  // From no load a force says nothing of the indentation, which the other way searches.
  const bool found = (load.kind == LoadKind::indentation || in_contact()) &&
                     newton_.solve(problem_, step, iterate);
  try {
    if (found) {
      state_ = surface_state(problem_, step, std::move(iterate.force), iterate.indentation,
                             newton_.iterations());
    } else {
      ++fallbacks_;
      newton_.forget();
      state_ = solve_contact_step(problem_, step, state_.force);
    }
  } catch (...) {
    if (place_) {
      map_.at(*place_, problem_.compliance);
    }
    throw;
  }
  place_ = place;
  return state_;
}

SlidingContact::OnsetDistance SlidingContact::onset_distance(const std::array<double, 2>& direction,
                                                             bool half_model) const {
  CellVector sliding(state_.force.size(), 0.0);
  for (int cell = 0; cell < problem_.cells(); ++cell) {
    const std::size_t at = 3 * static_cast<std::size_t>(cell);
    const double limit = problem_.friction_limit(cell, state_.force[at], 0, 0);
    sliding[at] = state_.force[at];
    sliding[at + 1] = limit * direction[0];
    sliding[at + 2] = limit * direction[1];
  }
  const CellVector surface = problem_.surface_displacement(sliding);
  std::array<double, 2> left{}, whole{};
  for (std::size_t at = 0; at < surface.size(); at += 3) {
    for (std::size_t c = 0; c < (half_model ? 1u : 2u); ++c) {
      left[c] += surface[at + 1 + c] - state_.surface[at + 1 + c];
      whole[c] += surface[at + 1 + c];
    }
  }
  const auto cells = static_cast<double>(problem_.area.size());
  return {std::hypot(left[0], left[1]) / cells, std::hypot(whole[0], whole[1]) / cells};
}

} // namespace ionskin::mechanics
