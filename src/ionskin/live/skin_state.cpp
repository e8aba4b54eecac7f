// SPDX-License-Identifier: Apache-2.0
#include "ionskin/live/skin.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ionskin::live {
namespace {

/// Bound on the cell forces and displacements of a valid state, over the largest trained force and
/// indentation [1]. A step limits its load to the trained one, and so leaves far smaller values.
constexpr double wildest = 1e6;
/// Bound on the memory of friction and on the numbers of the charges in a valid state, in SI units:
/// small enough that a step cannot overflow.
constexpr double largest = 1e30;
constexpr double rounding = 1e-12; // of the steepest tilt

bool all_within(std::span<const double> values, double most) {
  return std::ranges::all_of(values, [=](double value) { return std::abs(value) <= most; });
}

} // namespace

void Skin::reset() noexcept {
  contact_.leave();
  std::fill(state_.begin(), state_.end(), 0.0);
  state_[assembled_x] = state_[assembled_y] = std::numeric_limits<double>::quiet_NaN();
}

bool Skin::restore(std::span<const double> state) noexcept {
  if (!may_be_state(state)) {
    return false;
  }
  std::copy(state.begin(), state.end(), state_.begin());
  contact_.leave();
  contact_.assemble(contact_state());
  return true;
}

void Skin::exchange(std::vector<double>& state, laws::Friction& friction) noexcept {
  state_.swap(state);
  contact_.exchange(friction, contact_state());
}

bool Skin::is_place(double x, double y) const noexcept {
  return x >= data_.lowest_place[0] && x <= data_.highest_place[0] && y >= data_.lowest_place[1] &&
         y <= data_.highest_place[1];
}

bool Skin::may_be_state(std::span<const double> state) const noexcept {
  if (state.size() != state_.size()) {
    return false;
  }
  if (state[started] == 0) { // before the first step, only the state that `reset` sets is valid
    return std::isnan(state[assembled_x]) && std::isnan(state[assembled_y]) &&
           all_within(state.first(assembled_x), 0) && all_within(state.subspan(indentation), 0);
  }
  const auto part = [&](std::size_t begin, std::size_t end) {
    return state.subspan(begin, end - begin);
  };
  const double most_force = wildest * data_.heaviest_force,
               most_length = wildest * data_.deepest_indentation;
  for (std::size_t at = force_; at < surface_; at += 3) {
    if (!(state[at] >= 0)) { // the normal force of a cell cannot be negative
      return false;
    }
  }
  return state[started] == 1 && std::isfinite(state[last_time]) &&
         is_place(state[last_x], state[last_y]) &&
         is_place(state[assembled_x], state[assembled_y]) && std::isfinite(state[indentation]) &&
         std::abs(state[last_yaw]) <= most_turned &&
         std::hypot(state[last_roll], state[last_pitch]) <= (1 + rounding) * data_.steepest &&
         state[indentation] <= most_length && all_within(part(force_, surface_), most_force) &&
         all_within(part(surface_, memory_), most_length) &&
         all_within(part(memory_, signals_), largest) &&
         all_within(state.subspan(signals_), std::numeric_limits<double>::max());
}

LiveContact::State Skin::contact_state() noexcept {
  const std::size_t size = 3 * data_.area.size();
  return {std::span(state_).subspan(force_, size),
          std::span(state_).subspan(surface_, size),
          std::span(state_).subspan(memory_, contact_.memory_size()),
          state_[indentation],
          state_[assembled_x],
          state_[assembled_y]};
}

} // namespace ionskin::live
