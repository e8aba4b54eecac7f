// SPDX-License-Identifier: Apache-2.0
#include "ionskin/live/skin.hpp"

#include "ionskin/live/data/slope_table.hpp"
#include "ionskin/mechanics/surface/covered_area.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ionskin::live {
namespace {

// Places of the signals that every skin has.
enum : std::size_t {
  slider_x,
  slider_y,
  slider_z,
  normal_force,
  tangential_force,
  tangential_force_x,
  tangential_force_y,
  contact_area,
  stick_share,
  mean_shear,
  shear_first_moment,
  charge_top,
  charge_bottom,
  current_top,
  current_bottom,
  current_difference,
  current_common,
  residual,
  common
};

constexpr double rough = 1e-3;  // residual
constexpr double margin = 1e-2; // of what follows from a place and a load within the trained range
constexpr double turn_rounding = 1e-9; // [rad]
constexpr double load_rounding = 1e-6; // of a load over the trained one
constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// Distance from the trained positions that does not count: a small share of the smallest contact
/// cell, because no real slider follows a trained line exactly [m].
double place_tolerance(const SkinData& data) {
  constexpr double share = 0.05;
  double smallest = std::numeric_limits<double>::infinity();
  for (const std::vector<double>* lines : {&data.cell_lines_x, &data.cell_lines_y}) {
    for (std::size_t i = 1; i < lines->size(); ++i) {
      smallest = std::min(smallest, (*lines)[i] - (*lines)[i - 1]);
    }
  }
  return share * smallest;
}

/// Distance of the farthest corner of the contact cells from the slider's centre [m].
double reach(const SkinData& data) {
  const auto along = [](const std::vector<double>& lines) {
    return std::max(std::abs(lines.front()), std::abs(lines.back()));
  };
  return std::hypot(along(data.cell_lines_x), along(data.cell_lines_y));
}

/// True of motions across the plane of symmetry of a half skin, which knows what is alike on both
/// halves.
bool across(std::size_t motion) {
  return motion == 1 || motion == 3 || motion == 5;
}

} // namespace

Skin::Skin(const SkinData& data)
    : data_(data), reach_(reach(data)), place_tolerance_(place_tolerance(data)), contact_(data),
      regions_(1 + data.taxels.size()), spread_(data) {
  names_ = {"slider_x",           "slider_y",           "slider_z",
            "normal_force",       "tangential_force",   "tangential_force_x",
            "tangential_force_y", "contact_area",       "stick_share",
            "mean_shear",         "shear_first_moment", "charge_top",
            "charge_bottom",      "current_top",        "current_bottom",
            "current_difference", "current_common",     "residual"};
  for (const char* quantity : {"current_top_", "charge_top_"}) {
    for (const std::string& taxel : data.taxels) {
      names_.push_back(quantity + taxel);
    }
  }
  // Behind the others, which keep their places.
  names_.insert(names_.end(), {"moment_x", "moment_y", "moment_z"});
  const std::size_t size = 3 * data.area.size(), outputs = sides * regions_;
  force_ = singles;
  surface_ = force_ + size;
  memory_ = surface_ + size;
  filters_ = memory_ + contact_.memory_size();
  drives_ = filters_ + outputs * data.rates.size();
  waves_ = drives_ + outputs * data.rates.size();
  charges_ = waves_ + 2 * spread_.waves();
  signals_ = charges_ + outputs;
  state_.resize(signals_ + names_.size());
  before_.resize(state_.size());
  for (const ChannelMap& channel : data.channels) {
    fields_.emplace_back(channel, data.area.size());
    levels_.resize(std::max(levels_.size(), regions_ * channel.mean.size()));
  }
  for (std::size_t region = 0; region < regions_; ++region) {
    const std::array<double, 4> whole{0, 0, data.length, data.width};
    const double* at = region == 0 ? whole.data() : &data.taxel_corners[4 * (region - 1)];
    auto& own = region_corners_.emplace_back();
    for (std::size_t i = 0; i < own.size(); ++i) {
      const std::array<double, 2> corner{at[2 * (i % 2)], at[2 * (i / 2) + 1]};
      own[i] = static_cast<std::size_t>(std::ranges::find(corners_, corner) - corners_.begin());
      if (own[i] == corners_.size()) {
        corners_.push_back(corner);
      }
    }
    region_share_.push_back((at[2] - at[0]) * (at[3] - at[1]) / (data.length * data.width));
  }
  corner_levels_.resize(levels_.size() / regions_ * corners_.size());
  passes_.resize(data.rates.size());
  wave_drive_.resize(spread_.waves());
  wave_slope_.resize(spread_.waves());
  charge_.resize(outputs);
  charge_slope_.resize(outputs);
  pressure_.resize(data.area.size());
  reset();
}

bool Skin::set_friction(double coefficient) {
  if (!(coefficient >= data_.lowest_friction && coefficient <= data_.highest_friction)) {
    return false;
  }
  contact_.set_friction(coefficient);
  return true;
}

/// Forces and moments, docs/model.md (79), and areas.
void Skin::add_contact(std::span<double> signals) noexcept {
  double touching = 0, sticking = 0;
  std::array<double, 3> sum{}, moment{};
  for (std::size_t cell = 0; cell < data_.area.size(); ++cell) {
    const double* force = state_.data() + force_ + 3 * cell;
    for (std::size_t c = 0; c < 3; ++c) {
      sum[c] += force[c] / data_.meshed_share;
    }
    const auto [x, y] = contact_.middle(cell);
    moment[0] -= y * force[0] / data_.meshed_share;
    moment[1] += x * force[0] / data_.meshed_share;
    moment[2] += (x * force[2] - y * force[1]) / data_.meshed_share;
    pressure_[cell] = force[0] / data_.area[cell];
    if (force[0] > 0) {
      touching += data_.area[cell];
      sticking += contact_.slips(cell) ? 0 : data_.area[cell];
    }
  }
  if (data_.meshed_share < 1) {
    sum[2] = moment[0] = moment[2] = 0; // those of both halves cancel
  }
  signals[normal_force] = sum[0];
  signals[tangential_force] = sum[1] * data_.direction[0] + sum[2] * data_.direction[1];
  signals[tangential_force_x] = sum[1];
  signals[tangential_force_y] = sum[2];
  std::ranges::copy(moment, signals.end() - static_cast<std::ptrdiff_t>(moment.size()));
  signals[contact_area] =
      mechanics::covered_area({data_.cell_lines_x, data_.cell_lines_y, data_.area}, pressure_) /
      data_.meshed_share;
  signals[stick_share] = touching > 0 ? sticking / touching : 0;
}

std::uint32_t Skin::step(double time, const std::array<double, 2>& place, const Angles& angles,
                         bool is_force, double value, std::span<double> signals) noexcept {
  return finish(press(time, place, angles, is_force, value, signals), signals);
}

/// Second part of a step of this skin alone.
/// @returns the flags
std::uint32_t Skin::finish(const Pressed& pressed, std::span<double> signals) noexcept {
  if ((pressed.flags & flag::refused) == 0) {
    if (pressed.touches) {
      const ChannelField::Touch own = touch(pressed);
      for (ChannelField& field : fields_) {
        field.set({&own, 1});
      }
    }
    tell(pressed, fields_, 0, signals);
  }
  return pressed.flags;
}

ChannelField::Touch Skin::touch(const Pressed& pressed) const noexcept {
  return {pressed.place, std::span(state_).subspan(force_, 3 * data_.area.size())};
}

/// @param angles become those that are taken
/// @param outside becomes true where they are others
LiveContact::Stance Skin::stance(Angles& angles, bool first, bool& outside) const noexcept {
  auto& [roll, pitch, yaw] = angles;
  LiveContact::Stance result;
  if (data_.turns_into_itself != 0 || turns_underside(data_)) {
    result.turn = first ? 0 : yaw - state_[last_yaw];
    result.yaw = turns_underside(data_) ? yaw : 0;
  } else {
    outside = yaw != 0;
    yaw = 0;
  }
  const double tilt = std::hypot(roll, pitch);
  if (tilt > data_.steepest) {
    outside = outside || tilt > (1 + load_rounding) * data_.steepest;
    roll *= data_.steepest / tilt;
    pitch *= data_.steepest / tilt;
  }
  if (tilt > 0 && data_.steepest > 0) {
    const double along_x = -std::tan(pitch), along_y = std::tan(roll), c = std::cos(yaw),
                 s = std::sin(yaw);
    result.slope = {c * along_x - s * along_y, s * along_x + c * along_y};
    result.lowest = at_slope(data_.slopes, data_.lowest, {along_x, along_y});
  }
  return result;
}

Skin::Pressed Skin::press(double time, const std::array<double, 2>& place, const Angles& angles,
                          bool is_force, double value, std::span<double> signals) noexcept {
  const bool first = state_[started] == 0;
  if (!(std::isfinite(time) && std::isfinite(place[0]) && std::isfinite(place[1]) &&
        std::isfinite(value) && std::isfinite(angles[0]) && std::isfinite(angles[1]) &&
        std::abs(angles[2]) <= most_turned) ||
      (!first && time < state_[last_time])) {
    std::copy_n(state_.begin() + static_cast<std::ptrdiff_t>(signals_), names_.size(),
                signals.begin());
    return {flag::refused};
  }
  Pressed pressed{0, place, first ? 0 : time - state_[last_time], first, false};
  bool outside = false;
  std::array<double, 2>& at = pressed.place;
  std::array<double, 2> travel{};
  for (std::size_t d = 0; d < 2; ++d) {
    at[d] = std::clamp(place[d], data_.lowest_place[d], data_.highest_place[d]);
    outside = outside || std::abs(at[d] - place[d]) > place_tolerance_;
    travel[d] = first ? 0 : at[d] - state_[last_x + d];
  }
  bool outside_pose = false;
  Angles taken = angles;
  const LiveContact::Stance stands = stance(taken, first, outside_pose);
  const bool fast =
      std::hypot(travel[0], travel[1]) > (1 + margin) * data_.fastest * pressed.time_step + 1e-9 ||
      std::abs(stands.turn) > (1 + margin) * data_.fastest_turn * pressed.time_step + turn_rounding;
  state_[started] = 1;
  state_[last_time] = time;
  state_[last_x] = at[0];
  state_[last_y] = at[1];
  state_[last_yaw] = taken[2];
  state_[last_roll] = taken[0];
  state_[last_pitch] = taken[1];
  const double trained = is_force ? data_.heaviest_force : data_.deepest_indentation,
               load = std::min(is_force ? value : -value, trained);
  const double left =
      contact_.step(pressed.time_step, at, travel, stands,
                    {is_force, is_force ? load * data_.meshed_share : load}, contact_state());
  add_contact(signals);
  signals[slider_x] = at[0];
  signals[slider_y] = at[1];
  signals[slider_z] = -state_[indentation];
  signals[residual] = left;
  std::uint32_t& flags = pressed.flags;
  if (!(left <= rough)) {
    flags |= flag::unconverged;
  }
  const bool touches = pressed.touches = signals[normal_force] > 0;
  flags |= touches && outside ? flag::outside_place : 0;
  flags |= touches && outside_pose ? flag::outside_pose : 0;
  // In a landing, too: the way to it counts as slip, however far it is.
  flags |= touches && fast ? flag::outside_speed : 0;
  // A height within the range may press heavier than trained elsewhere; a force is met.
  const bool heavy = (is_force ? value : -value) > (1 + load_rounding) * trained ||
                     (!is_force && signals[normal_force] > (1 + margin) * data_.heaviest_force);
  flags |= heavy ? flag::outside_load : 0;
  flags |= is_force && value < 0 ? flag::pulled : 0;
  last_ = pressed;
  return pressed;
}

bool Skin::stiffness(std::span<double, 36> matrix) noexcept {
  const bool known = contact_.stiffness(contact_state(), matrix);
  for (std::size_t row = 0; row < motions; ++row) {
    for (std::size_t motion = 0; motion < motions; ++motion) {
      double& value = matrix[motions * row + motion];
      value /= data_.meshed_share;
      if (data_.meshed_share < 1) {
        value = across(motion) ? unknown : across(row) ? 0 : value;
      }
      value = known ? value : unknown;
    }
  }
  return known;
}

bool Skin::charge_derivatives(std::span<double> matrix) noexcept {
  std::array<double, motions * motions> stiffness{};
  const bool known = contact_.stiffness(contact_state(), stiffness),
             touches = known && last_.touches;
  ChannelField& driving = fields_.back();
  if (touches) {
    driving.differentiate(touch(last_), contact_.force_by_motion());
  }
  std::ranges::fill(charge_slope_, 0.0);
  for (std::size_t motion = 0; motion < motions; ++motion) {
    if (touches) {
      set_charge_slopes(driving, motion);
    }
    const bool derivable = known && !(data_.meshed_share < 1 && across(motion));
    for (std::size_t charge = 0; charge < charges(); ++charge) {
      const std::size_t output = charge < sides ? charge : sides * (charge - sides + 1);
      matrix[motions * charge + motion] = derivable ? charge_slope_[output] : unknown;
    }
  }
  return known;
}

void Skin::tell(const Pressed& pressed, std::span<const ChannelField> fields, std::size_t lane,
                std::span<double> signals) noexcept {
  signals[mean_shear] = signals[shear_first_moment] = 0;
  for (const ChannelField& field : fields) {
    const std::size_t levels = field.levels();
    if (!pressed.touches) {
      std::fill(levels_.begin(), levels_.end(), 0.0);
      continue;
    }
    set_field_levels(field, lane, pressed.place);
    if (&field == fields.data()) {
      const double volume = data_.length * data_.width * data_.thickness;
      for (std::size_t i = 0; i < levels; ++i) {
        signals[mean_shear] += field.map().mean[i] * levels_[i] / volume;
        signals[shear_first_moment] += field.map().moment[i] * levels_[i] / volume;
      }
    }
  }
  add_charges(pressed.time_step, pressed.first);
  add_spread(pressed, fields.back().amplitude(lane));
  const auto current = [&](std::size_t output) {
    return pressed.first || pressed.time_step == 0
               ? 0.0
               : (charge_[output] - state_[charges_ + output]) / pressed.time_step;
  };
  signals[charge_top] = charge_[0];
  signals[charge_bottom] = charge_[1];
  signals[current_top] = current(0);
  signals[current_bottom] = current(1);
  signals[current_difference] = (signals[current_top] - signals[current_bottom]) / 2;
  signals[current_common] = (signals[current_top] + signals[current_bottom]) / 2;
  for (std::size_t taxel = 0; taxel + 1 < regions_; ++taxel) {
    signals[common + taxel] = current(sides * (taxel + 1));
    signals[common + regions_ - 1 + taxel] = charge_[sides * (taxel + 1)];
  }
  if (pressed.first || pressed.time_step > 0) { // else the next step's current has this charge, too
    std::copy(charge_.begin(), charge_.end(),
              state_.begin() + static_cast<std::ptrdiff_t>(charges_));
  }
  std::copy_n(signals.begin(), names_.size(),
              state_.begin() + static_cast<std::ptrdiff_t>(signals_));
}

} // namespace ionskin::live
