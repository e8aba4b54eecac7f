// SPDX-License-Identifier: Apache-2.0
#include "ionskin/live/contact/live_contact.hpp"

#include "ionskin/live/data/place_amplitudes.hpp"
#include "ionskin/mechanics/path/path_steps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace ionskin::live {
namespace {

/// Residual, as `LiveContact::step` returns it, at which the iterations stop [1].
constexpr double tolerance = 1e-6;
/// Residual at which the parts of a step before the last one stop [1].
constexpr double part_tolerance = 1e-4;
/// Distance from the assembled position within which the compliance is reused, since it changes by
/// less than 1e-5 of itself [m].
constexpr double assembly_distance = 5e-6;
/// Lower bound on the duration of a step, since some friction laws take 0 for steady sliding [s].
constexpr double shortest_step = 1e-9;
/// Residual above which a step under a given force searches for the indentation [1].
constexpr double searched = 1e-4;
/// Relative distance of a traction from its limit below which the cell counts as slipping [1].
/// Under a slider that rests after sliding, tractions stay at their limit as exactly as the steps
/// are solved.
constexpr double slipping = 1e-3;

/// Change of the load, over the largest one, that is solved at once, as in the full model: what
/// sticks under another load depends on the way there [1].
constexpr double loaded_at_once = 1.0 / mechanics::PathSteps{}.lift_off;

/// Gap from which a cell lies beyond the underside [m].
constexpr double beyond_underside = 0.1;

/// Number of values of a cell in the memory of a law with elastic slip: slip along x and y [m],
/// limit traction [Pa].
constexpr std::size_t of_elastic_slip = 3;

/// Number of values of a cell in the memory of the friction law, enough for any trained
/// coefficient.
std::size_t memory_per_cell(const SkinData& data) {
  const laws::Friction friction = friction_of(data, data.highest_friction);
  return friction.elastic_slip > 0 ? of_elastic_slip : friction.lag > 0 ? 1 : 0;
}

} // namespace

LiveContact::LiveContact(const SkinData& data)
    : data_(data), friction_(friction_of(data, data.friction)), size_(3 * data.area.size()),
      memory_size_(memory_per_cell(data) * data.area.size()), gap_(data.gap),
      upright_gap_(data.gap), gap_by_yaw_(data.gap.size()),
      first_touch_(*std::min_element(data.gap.begin(), data.gap.end())),
      compliance_(data.compliance.modes() > 0 ? size_ * size_ : 0), assembled_(size_), own_(size_),
      before_(size_), amplitude_(data.compliance.modes()), drag_(data.area.size()),
      slips_(data.area.size()), correction_(data.area.size()), tangential_(data.area.size()),
      touching_(data.area.size()), change_(data.area.size()), from_indentation_(data.area.size()),
      memory_before_(memory_size_), force_by_motion_(motions * size_),
      surface_by_motion_(motions * size_) {
  for (std::size_t at = 0; at < (1 + amplitude_.size()) * size_; ++at) {
    const std::size_t mode = at / size_, own = at % size_;
    diagonals_.push_back(data.compliance.values[(mode * size_ + own) * size_ + own]);
  }
  if (amplitude_.empty()) { // no modes: identical compliance at every position
    own_.assign(diagonals_.begin(), diagonals_.end());
  }
  const std::vector<double>&x = data.cell_lines_x, &y = data.cell_lines_y;
  for (std::size_t j = 1; j < y.size(); ++j) {
    for (std::size_t i = 1; i < x.size(); ++i) {
      middle_.push_back({(x[i - 1] + x[i]) / 2, (y[j - 1] + y[j]) / 2});
    }
  }
}

void LiveContact::set_friction(double coefficient) {
  friction_ = friction_of(data_, coefficient);
}

void LiveContact::assemble(const State& state) noexcept {
  stepped_ = false;
  if (std::isnan(state.assembled_x)) {
    return;
  }
  place_amplitudes(data_.compliance, {state.assembled_x, state.assembled_y}, amplitude_);
  std::ranges::fill(assembled_, char{0});
  for (std::size_t at = 0; at < size_; ++at) {
    const float* mode = &diagonals_[at];
    own_[at] = static_cast<double>(*mode);
    for (const double amplitude : amplitude_) {
      mode += size_;
      own_[at] += amplitude * static_cast<double>(*mode);
    }
  }
}

void LiveContact::exchange(laws::Friction& friction, const State& state) noexcept {
  std::swap(friction_, friction);
  stepped_ = false;
  if (!amplitude_.empty()) {
    assemble(state);
  }
}

/// Column of the compliance at the assembled position, assembled when first asked for:
/// displacements [3 cells] under a unit force [m/N].
/// @param at index of the force component, of [3 cells]
const float* LiveContact::column(std::size_t at) noexcept {
  if (amplitude_.empty()) { // no modes: identical compliance at every position
    return data_.compliance.values.data() + at * size_;
  }
  float* column = compliance_.data() + at * size_;
  if (!assembled_[at]) {
    assembled_[at] = 1;
    const float* mode = data_.compliance.values.data() + at * size_;
    std::copy(mode, mode + size_, column);
    for (const double amplitude : amplitude_) {
      mode += size_ * size_;
      for (std::size_t row = 0; row < size_; ++row) {
        column[row] += static_cast<float>(amplitude) * mode[row];
      }
    }
  }
  return column;
}

/// Adds the surface displacements under additional forces on a cell.
/// @param force additional force: normal, along x, along y [N]
void LiveContact::add(std::size_t cell, const std::array<double, 3>& force, State& state) noexcept {
  const float *x = column(3 * cell), *y = column(3 * cell + 1), *z = column(3 * cell + 2);
  double* surface = state.surface.data();
  // Single precision is as exact as the compliance itself, and twice as fast as in double
  // precision.
  const auto normal = static_cast<float>(force[0]), along_x = static_cast<float>(force[1]),
             along_y = static_cast<float>(force[2]);
  for (std::size_t row = 0; row < size_; ++row) {
    surface[row] += static_cast<double>(normal * x[row] + along_x * y[row] + along_y * z[row]);
  }
}

/// Sets the gaps of the cells under the upright underside at a yaw, linear between those of the
/// table. Where the underside ends between two of its yaws, the nearer one decides.
void LiveContact::turn_underside(double yaw) noexcept {
  constexpr double full_turn = 2 * std::numbers::pi;
  const std::size_t cells = gap_.size(), yaws = data_.turned_gap.size() / cells;
  const double turns = yaw / full_turn,
               at = (turns - std::floor(turns)) * static_cast<double>(yaws);
  const auto low = static_cast<std::size_t>(at) % yaws, high = (low + 1) % yaws;
  const double weight = at - std::floor(at);
  for (std::size_t cell = 0; cell < cells; ++cell) {
    const double before = data_.turned_gap[low * cells + cell],
                 behind = data_.turned_gap[high * cells + cell];
    const bool both = std::max(before, behind) < beyond_underside;
    upright_gap_[cell] = both ? std::lerp(before, behind, weight) : weight < 0.5 ? before : behind;
    gap_by_yaw_[cell] = both ? (behind - before) * static_cast<double>(yaws) / full_turn : 0;
  }
}

/// Sets the gaps of the cells under the underside in a stance, docs/model.md (77).
void LiveContact::pose(const Stance& stance) noexcept {
  const auto& [x, y] = stance.slope;
  const bool turned = !data_.turned_gap.empty(), tilted = x != 0 || y != 0;
  if (turned) {
    turn_underside(stance.yaw);
  }
  if (tilted || turned || posed_) {
    first_touch_ = std::numeric_limits<double>::infinity();
    for (std::size_t cell = 0; cell < gap_.size(); ++cell) {
      gap_[cell] = upright_gap_[cell] +
                   (tilted ? x * middle_[cell][0] + y * middle_[cell][1] - stance.lowest : 0.0);
      first_touch_ = std::min(first_touch_, gap_[cell]);
    }
    posed_ = tilted || turned;
  }
}

/// Slip of the slider relative to the skin's surface at a cell in the step, docs/model.md (78) [m].
std::array<double, 2> LiveContact::slip(std::size_t cell, const State& state) const noexcept {
  const std::size_t at = 3 * cell;
  const auto& [x, y] = middle_[cell];
  return {travel_[0] - turn_ * y - (state.surface[at + 1] - before_[at + 1]),
          travel_[1] + turn_ * x - (state.surface[at + 2] - before_[at + 2])};
}

/// Response of the friction law at a cell under a normal force [N], for the present surface
/// displacements.
laws::FrictionResponse LiveContact::friction_at(std::size_t cell, double normal,
                                                const State& state) const noexcept {
  const std::size_t at = 3 * cell;
  const double own = std::max(own_[at + 1], own_[at + 2]), area = data_.area[cell];
  const auto [slip_x, slip_y] = slip(cell, state);
  return laws::return_mapping(friction_, {normal / area,
                                          {(state.force[at + 1] + slip_x / own) / area,
                                           (state.force[at + 2] + slip_y / own) / area},
                                          own * area,
                                          time_step_,
                                          friction_.lag > 0 ? state.memory[cell] : 0.0,
                                          elastic_slip(cell, state)});
}

/// Elastic slip of a cell as the memory holds it, which is that at the beginning of the step until
/// `remember` replaces it; zeros for a law without elastic slip.
laws::ElasticSlip LiveContact::elastic_slip(std::size_t cell, const State& state) const noexcept {
  if (friction_.elastic_slip == 0) {
    return {};
  }
  const double* memory = &state.memory[of_elastic_slip * cell];
  return {{memory[0], memory[1]}, memory[2]};
}

/// Sets, at the end of a step, which cells slip, and the memory of the friction law; all zeros
/// without friction.
void LiveContact::remember(State& state) noexcept {
  if (friction_.coefficient == 0) {
    std::fill(state.memory.begin(), state.memory.end(), 0.0);
  }
  for (std::size_t cell = 0, at = 0; at < size_; ++cell, at += 3) {
    const bool touches = state.force[at] > 0;
    const double area = data_.area[cell], lagged = friction_.lag > 0 ? state.memory[cell] : 0;
    const double limit = friction_.limit({state.force[at] / area, 0, 0, lagged});
    slips_[cell] = touches && laws::limit_norm(friction_, {state.force[at + 1] / area,
                                                           state.force[at + 2] / area}) >=
                                  (1 - slipping) * limit;
    const auto [slip_x, slip_y] = slip(cell, state);
    if (friction_.elastic_slip > 0) {
      const laws::ElasticSlip elastic =
          laws::divided_slip(friction_, elastic_slip(cell, state),
                             {state.force[at] / area, 0, time_step_, lagged}, {slip_x, slip_y})
              .elastic;
      double* memory = &state.memory[of_elastic_slip * cell];
      memory[0] = elastic.slip[0];
      memory[1] = elastic.slip[1];
      memory[2] = elastic.limit;
    } else if (friction_.lag > 0) {
      const double left = std::exp(-time_step_ / friction_.lag);
      const double speed = std::hypot(slip_x, slip_y) / time_step_;
      state.memory[cell] = touches ? left * lagged + (1 - left) * speed : 0;
    }
  }
}

double LiveContact::step(double time_step, const std::array<double, 2>& place,
                         const std::array<double, 2>& travel, const Stance& stance,
                         const Load& load, State state) noexcept {
  pose(stance);
  const bool moved = !(std::hypot(place[0] - state.assembled_x, place[1] - state.assembled_y) <=
                       assembly_distance);
  if (moved) {
    state.assembled_x = place[0];
    state.assembled_y = place[1];
    assemble(state);
  }
  std::ranges::fill(slips_, char{0});
  stepped_ = true;
  add_up(state);
  const double before = load.is_force ? total_ : std::max(state.indentation, first_touch_);
  const int parts = parts_of(load, before);
  time_step_ = std::max(time_step / parts, shortest_step);
  travel_ = {travel[0] / parts, travel[1] / parts};
  turn_ = stance.turn / parts;
  if (load.value <= (load.is_force ? 0.0 : first_touch_)) {
    std::fill(state.force.begin(), state.force.end(), 0.0);
    std::fill(state.surface.begin(), state.surface.end(), 0.0);
    std::fill(state.memory.begin(), state.memory.end(), 0.0);
    state.indentation = load.is_force ? first_touch_ : load.value;
    return 0;
  }
  double residual = 0;
  for (int part = 1; part <= parts; ++part) {
    tolerance_ = part < parts ? part_tolerance : tolerance;
    const double value = std::lerp(before, load.value, static_cast<double>(part) / parts);
    const double left = advance({load.is_force, value}, state);
    if (part == parts || left > part_tolerance) {
      residual = std::max(residual, left);
    }
  }
  return residual;
}

/// Number of parts into which a step is divided.
/// @param before load at the beginning of the step
int LiveContact::parts_of(const Load& load, double before) const noexcept {
  const bool flat = std::ranges::all_of(gap_, [&](double gap) { return gap == first_touch_; });
  if (total_ == 0 && flat && laws::is_proportional(friction_)) {
    return 1; // the solution is proportional to the load
  }
  const double largest =
      load.is_force ? data_.meshed_share * data_.heaviest_force : data_.deepest_indentation;
  const double parts = std::ceil(std::abs(before - load.value) / (loaded_at_once * largest));
  return parts > 1 ? static_cast<int>(std::min(parts, 1 / loaded_at_once)) : 1;
}

/// Solves one part of a step, of which `time_step_`, `travel_` and `turn_` are those of the part.
/// @returns residual, as `step` returns it [1]
double LiveContact::advance(const Load& load, State& state) noexcept {
  std::ranges::copy(state.memory, memory_before_.begin());
  std::copy(state.surface.begin(), state.surface.end(), before_.begin());
  std::fill(state.surface.begin(), state.surface.end(), 0.0);
  for (std::size_t cell = 0, at = 0; at < size_; ++cell, at += 3) {
    if (state.force[at] != 0) {
      add(cell, {state.force[at], state.force[at + 1], state.force[at + 2]}, state);
    }
  }
  double residual = settle(load, state);
  if (load.is_force && residual > searched) {
    residual = search(load, state);
  }
  remember(state);
  return residual;
}

} // namespace ionskin::live
