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

/// After the step before; what friction remembered in that step stays known until the next.
std::vector<double> SlidingContact::next_lagged_speed() const {
  const double lag = problem_.friction.lag, time_step = state_.step.time_step;
  if (lag == 0 || time_step == 0) {
    return problem_.lagged_speed;
  }
  std::vector<double> speed = problem_.lagged_speed;
  speed.resize(problem_.area.size(), 0.0);
  const double left = std::exp(-time_step / lag);
  for (std::size_t cell = 0; cell < speed.size(); ++cell) {
    const bool touches = state_.force[3 * cell] > 0;
    speed[cell] = touches ? left * speed[cell] + (1 - left) * state_.slip[cell] / time_step : 0.0;
  }
  return speed;
}

/// The surface displacement as it would be without the elastic slip, which is to be slipped again.
CellVector SlidingContact::held_surface() const {
  CellVector surface = state_.surface;
  for (std::size_t cell = 0; cell < elastic_slip_.size(); ++cell) {
    surface[3 * cell + 1] += elastic_slip_[cell][0];
    surface[3 * cell + 2] += elastic_slip_[cell][1];
  }
  return surface;
}

/// Divides the slip of the present state into what is elastic and what is not.
void SlidingContact::keep_elastic_slip() {
  const double most = problem_.friction.elastic_slip;
  if (most == 0) {
    return;
  }
  elastic_slip_.resize(problem_.area.size());
  for (int cell = 0; cell < problem_.cells(); ++cell) {
    const auto at = static_cast<std::size_t>(cell);
    const auto slip = slip_increment(state_.step, state_.surface, cell);
    const double length = std::hypot(slip[0], slip[1]);
    const double share = state_.force[3 * at] <= 0 ? 0.0 : length > most ? most / length : 1.0;
    elastic_slip_[at] = {share * slip[0], share * slip[1]};
    state_.slip[at] = (1 - share) * length;
  }
}

void SlidingContact::detach(const SliderStep& step) {
  elastic_slip_.clear();
  problem_.lagged_speed.clear();
  if (in_contact()) {
    std::fill(state_.force.begin(), state_.force.end(), 0.0);
    std::fill(state_.surface.begin(), state_.surface.end(), 0.0);
  }
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
  SliderStep step{load, {place[0] - from[0], place[1] - from[1]}, time_step, held_surface()};
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
  std::vector<double> lagged_speed = next_lagged_speed();
  problem_.lagged_speed.swap(lagged_speed);
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
    keep_elastic_slip();
  } catch (...) {
    problem_.lagged_speed.swap(lagged_speed);
    if (place_) {
      map_.at(*place_, problem_.compliance);
    }
    throw;
  }
  place_ = place;
  return state_;
}

SlidingContact::OnsetDistance SlidingContact::onset_distance(const std::array<double, 2>& direction,
                                                             bool half_model, double slip,
                                                             double time_step) const {
  CellVector sliding(state_.force.size(), 0.0);
  for (int cell = 0; cell < problem_.cells(); ++cell) {
    const std::size_t at = 3 * static_cast<std::size_t>(cell);
    const double limit = problem_.friction_limit(cell, state_.force[at], slip, time_step);
    const auto traction = laws::sliding_traction(problem_.friction, limit, direction);
    sliding[at] = state_.force[at];
    sliding[at + 1] = traction[0];
    sliding[at + 2] = traction[1];
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
  const double elastic = std::min(slip, problem_.friction.elastic_slip);
  return {std::hypot(left[0], left[1]) / cells + elastic,
          std::hypot(whole[0], whole[1]) / cells + elastic};
}

} // namespace ionskin::mechanics
