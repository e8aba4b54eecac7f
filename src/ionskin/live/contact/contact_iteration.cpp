// SPDX-License-Identifier: Apache-2.0

// The iteration of a part of a step: sweeps, Newton steps in between, and the search for an
// indentation.

#include "ionskin/live/contact/live_contact.hpp"

#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

namespace ionskin::live {
namespace {

/// Largest numbers of sweeps, and of Newton steps for the normal and for the tangential forces
/// after which the former open cells one by one and the latter become rare. The larger numbers are
/// for a step that begins without contact.
constexpr int most_sweeps = 60, most_landing_sweeps = 2000;
constexpr int most_factors = 8, most_landing_factors = 60;
/// Number of sweeps for each further Newton step for the tangential forces.
constexpr int sweeps_between = 4;
/// Lower bound on the normal stiffness in a Newton step, over the stiffness under the heaviest
/// load: a smaller contact is softer [1].
constexpr double softest = 0.1;
/// Largest numbers of doublings that bracket the indentation, and of iterations of the search.
constexpr int most_doublings = 30, most_searches = 60;

} // namespace

/// One projected Gauss-Seidel sweep over all cells: updates the force of each cell with the forces
/// of the other cells fixed.
LiveContact::Sweep LiveContact::sweep(State& state) noexcept {
  Sweep result;
  for (std::size_t cell = 0, at = 0; at < size_; ++cell, at += 3) {
    const double normal = std::max(
        0.0, state.force[at] + (state.indentation - gap_[cell] - state.surface[at]) / own_[at]);
    const double* force = &state.force[at];
    if (normal == 0 && force[0] == 0 && force[1] == 0 && force[2] == 0) {
      continue; // was open and stays open
    }
    const double area = data_.area[cell];
    const laws::FrictionResponse response = friction_at(cell, normal, state);
    drag_[cell] = response.by_normal;
    const std::array<double, 3> next{normal, area * response.traction[0],
                                     area * response.traction[1]};
    std::array<double, 3> difference{};
    for (std::size_t c = 0; c < 3; ++c) {
      difference[c] = next[c] - state.force[at + c];
      state.force[at + c] = next[c];
      result.change = std::max(result.change, std::abs(difference[c]));
    }
    result.normal_change = std::max(result.normal_change, std::abs(difference[0]));
    if (difference != std::array<double, 3>{}) {
      add(cell, difference, state);
    }
  }
  return result;
}

/// Indices of the cells whose normal force is positive, in `touching_`.
std::span<const std::size_t> LiveContact::find_touching(const State& state) noexcept {
  std::size_t count = 0;
  for (std::size_t cell = 0; cell < data_.area.size(); ++cell) {
    if (state.force[3 * cell] > 0) {
      touching_[count++] = cell;
    }
  }
  return std::span(touching_).first(count);
}

/// Sets up and factorises the normal compliance of the cells in contact; tangential forces follow
/// the normal force of their cell (`drag_`).
/// @returns false if the matrix could not be factorised
bool LiveContact::take_normal(std::span<const std::size_t> touching) noexcept {
  correction_.take(touching);
  for (std::size_t j = 0; j < touching.size(); ++j) {
    const std::size_t cell = touching[j];
    const float *normal = column(3 * cell), *x = column(3 * cell + 1), *y = column(3 * cell + 2);
    const auto drag_x = static_cast<float>(drag_[cell][0]),
               drag_y = static_cast<float>(drag_[cell][1]);
    const std::span<float> into = correction_.column(j);
    for (std::size_t i = 0; i < touching.size(); ++i) {
      const std::size_t row = 3 * touching[i];
      into[i] = normal[row] + drag_x * x[row] + drag_y * y[row];
    }
  }
  return correction_.factor();
}

/// Solves for the changes of the normal forces of the cells in contact, in `change_`, after which
/// the gaps of these cells are closed; under a given force, the indentation changes too.
/// @returns change of the indentation [m]
double LiveContact::solve_normal(const Load& load, std::span<const std::size_t> touching,
                                 const State& state) noexcept {
  const std::size_t count = touching.size();
  const std::span change = std::span(change_).first(count),
                  from_indentation = std::span(from_indentation_).first(count);
  for (std::size_t j = 0; j < count; ++j) {
    const std::size_t cell = touching[j];
    change[j] = static_cast<float>(state.indentation - gap_[cell] - state.surface[3 * cell]);
    from_indentation[j] = 1;
  }
  correction_.solve(change);
  if (!load.is_force) {
    return 0;
  }
  correction_.solve(from_indentation);
  const auto sum = [](std::span<const float> values) {
    return std::accumulate(values.begin(), values.end(), 0.0);
  };
  const double left = load.value - total_ - sum(change),
               deeper = left / std::max(sum(from_indentation), softest * data_.stiffness);
  for (std::size_t j = 0; j < count; ++j) {
    change[j] += static_cast<float>(deeper) * from_indentation[j];
  }
  return deeper;
}

/// Newton steps for the normal forces of the cells in contact. Tangential forces of slipping cells
/// follow the normal force; under a given force, the indentation changes too.
/// @param opening what happens to cells whose forces would become negative
/// @returns false, with the forces unchanged, if nothing touches or the matrix could not be
/// factorised
bool LiveContact::correct(const Load& load, Opening opening, State& state) noexcept {
  for (bool corrected = false;; corrected = true) {
    const std::span<const std::size_t> touching = find_touching(state);
    const std::size_t count = touching.size();
    if (count == 0 || !(correction_.is_of(touching) || take_normal(touching))) {
      return corrected;
    }
    const double deeper = solve_normal(load, touching, state);
    double share = 1;
    std::size_t first = count; // to open
    for (std::size_t j = 0; j < count && opening == Opening::one_by_one; ++j) {
      const double force = state.force[3 * touching[j]], change = static_cast<double>(change_[j]);
      if (force + share * change < 0) {
        share = -force / change;
        first = j;
      }
    }
    state.indentation += share * deeper;
    for (std::size_t j = 0; j < count; ++j) {
      const std::size_t cell = touching[j], at = 3 * cell;
      const double least = -state.force[at],
                   own = std::max(share * static_cast<double>(change_[j]), least),
                   normal = j == first ? least : own;
      const std::array<double, 3> force{normal, normal * drag_[cell][0], normal * drag_[cell][1]};
      for (std::size_t c = 0; c < 3; ++c) {
        state.force[at + c] += force[c];
      }
      add(cell, force, state);
    }
    if (first == count) {
      return true;
    }
    add_up(state);
  }
}

/// Newton step for the tangential forces, with the normal forces fixed.
/// @returns false, with the forces unchanged, if no tangential force can follow its slip
bool LiveContact::correct_friction(State& state) noexcept {
  tangential_.clear();
  for (std::size_t cell = 0, at = 0; at < size_; ++cell, at += 3) {
    if (state.force[at] > 0) {
      const laws::FrictionResponse response = friction_at(cell, state.force[at], state);
      tangential_.add(cell, std::max(own_[at + 1], own_[at + 2]), response.by_trial,
                      {data_.area[cell] * response.traction[0] - state.force[at + 1],
                       data_.area[cell] * response.traction[1] - state.force[at + 2]});
    }
  }
  tangential_.take([&](std::size_t at) { return column(at); });
  tangential_.solve();
  for (std::size_t i = 0; i < tangential_.count();) {
    const std::size_t cell = tangential_.cell(i);
    std::array<double, 3> force{};
    for (; i < tangential_.count() && tangential_.cell(i) == cell; ++i) { // its directions
      const std::array<double, 2> change = tangential_.change(i);
      force[1] += change[0];
      force[2] += change[1];
    }
    state.force[3 * cell + 1] += force[1];
    state.force[3 * cell + 2] += force[2];
    add(cell, force, state);
  }
  return tangential_.count() > 0;
}

/// Sets `largest_` and `total_` from the normal forces.
void LiveContact::add_up(const State& state) noexcept {
  largest_ = total_ = 0;
  for (std::size_t at = 0; at < size_; at += 3) {
    largest_ = std::max(largest_, state.force[at]);
    total_ += state.force[at];
  }
}

/// Alternates sweeps and Newton steps until the residual is within the tolerance, or the sweeps are
/// used up.
/// @returns residual, as `step` returns it [1]
double LiveContact::settle(const Load& load, State& state) noexcept {
  add_up(state);
  const bool landing = largest_ == 0;
  int factors = landing ? most_landing_factors : most_factors, frictions = factors;
  if (!load.is_force) {
    state.indentation = load.value;
  }
  correction_.forget();
  double residual = 1;
  for (int i = 0; i < (landing ? most_landing_sweeps : most_sweeps); ++i) {
    const Sweep changed = sweep(state);
    add_up(state);
    // While the slider is lifted, a sweep may unload all cells, before the surface rises and
    // touches the slider again at some of them.
    const double scale = largest_ > 0 ? 1 / largest_ : changed.change > 0 ? 1 / changed.change : 0;
    const double left = load.is_force ? std::abs(load.value - total_) / load.value : 0;
    residual = std::max(changed.change * scale, left);
    if (residual <= tolerance_) {
      break;
    }
    const bool rough = changed.normal_change * scale > tolerance_ || left > tolerance_;
    if (rough && correct(load, factors > 0 ? Opening::at_once : Opening::one_by_one, state)) {
      --factors;
    } else if (left > tolerance_) {
      state.indentation += (load.value - total_) / data_.stiffness;
    }
    if ((frictions > 0 || i % sweeps_between == 0) && changed.change * scale > tolerance_ &&
        correct_friction(state)) {
      --frictions;
    }
  }
  return residual;
}

/// Searches for the indentation that carries a given force, where Newton steps from a distant start
/// miss it. Brackets it between the first touch and an indentation that carries more, then finds
/// the root.
/// @returns residual, as `step` returns it [1]
double LiveContact::search(const Load& load, State& state) noexcept {
  double residual = 1;
  const auto excess = [&](double indentation) {
    residual = settle({false, indentation}, state);
    return total_ / load.value - 1;
  };
  double low = first_touch_, low_excess = -1, high = std::max(state.indentation, first_touch_),
         high_excess = -1;
  for (int i = 0; i < most_doublings && high_excess < 0; ++i) {
    low = i == 0 ? low : high;
    low_excess = i == 0 ? low_excess : high_excess;
    high += i == 0 ? 0 : load.value / data_.stiffness * std::exp2(i - 1);
    high_excess = excess(high);
  }
  if (high_excess < 0) {
    return std::max(residual, -high_excess);
  }
  double missed = high_excess;
  // In an invalid file, a cell with a negative compliance carries force at the first touch: there
  // is no bracket.
  if (high_excess > tolerance_ && low < high) {
    std::uintmax_t most = most_searches;
    const auto close = [&](double, double) { return std::abs(missed) <= tolerance_; };
    boost::math::tools::toms748_solve(
        [&](double indentation) { return missed = excess(indentation); }, low, high, low_excess,
        high_excess, close, most);
  }
  return std::max(residual, std::abs(missed));
}

} // namespace ionskin::live
