// SPDX-License-Identifier: Apache-2.0
#include "ionskin/live/fmu/instance.hpp"

#include "ionskin/live/fmu/model_description.hpp"

#include <algorithm>
#include <cmath>

namespace ionskin::live::fmu {
namespace {

/// Indices of the single numbers at the beginning of a state; the inputs follow at `singles`.
enum : std::size_t { place_of_mode, place_of_time, place_of_control, place_of_flags, singles };

} // namespace

Instance::Instance(SkinData data)
    : data_(std::move(data)), guid_(fmu::guid(data_)), skin_(data_), signals_(skin_.names().size()),
      trained_angles_(trained_angles(data_)) {
  const std::vector<Variable> list = variables(data_);
  for (std::size_t i = 0; i < start_.size(); ++i) {
    start_[i] = list[i].start;
  }
  reset();
}

void Instance::reset() {
  skin_.reset();
  std::fill(signals_.begin(), signals_.end(), 0.0);
  mode_ = Mode::instantiated;
  time_ = 0;
  inputs_ = start_;
  angles_ = {};
  force_control_ = followed_ = false;
  flags_ = 0;
}

bool Instance::trained(double friction) const {
  return friction >= data_.lowest_friction && friction <= data_.highest_friction;
}

bool Instance::limit_friction() {
  double& friction = inputs_[reference::friction];
  if (!std::isfinite(friction) || trained(friction)) {
    return false; // a step refuses a value that is not finite
  }
  friction = std::clamp(friction, data_.lowest_friction, data_.highest_friction);
  return true;
}

std::uint32_t Instance::evaluate(double time) {
  const double friction = inputs_[reference::friction];
  if (!std::isfinite(friction)) {
    return flag::refused;
  }
  if (friction != skin_.friction()) {
    skin_.set_friction(friction);
  }
  return skin_.step(time, {inputs_[reference::x], inputs_[reference::y]}, angles_, force_control_,
                    inputs_[force_control_ ? reference::force : reference::height], signals_);
}

void Instance::follow_inputs() {
  if (mode_ == Mode::initialization && !followed_) {
    skin_.reset();
    flags_ = evaluate(time_);
    followed_ = true;
  }
}

void Instance::exit_initialization() {
  follow_inputs();
  mode_ = Mode::stepping;
}

bool Instance::step(double time) {
  const std::uint32_t flags = evaluate(time);
  if ((flags & flag::refused) != 0) {
    return false;
  }
  flags_ = flags;
  time_ = time;
  return true;
}

const double* Instance::real(std::size_t reference) {
  if (const double* input = find_input(reference)) {
    return input;
  }
  if (!is_output(reference)) {
    return nullptr;
  }
  follow_inputs();
  return &signals_[reference - reference::signals];
}

double* Instance::input(std::size_t reference) {
  followed_ = false;
  return find_input(reference);
}

double* Instance::find_input(std::size_t reference) {
  if (reference < reference::inputs) {
    return &inputs_[reference];
  }
  const std::size_t first_angle = reference::signals + signals_.size();
  if (reference < first_angle || reference - first_angle >= trained_angles_.size()) {
    return nullptr;
  }
  return &angles_[trained_angles_[reference - first_angle]];
}

bool Instance::inputs_are_finite() const {
  const auto is_finite = [](double value) { return std::isfinite(value); };
  return std::ranges::all_of(inputs_, is_finite) && std::ranges::all_of(angles_, is_finite);
}

std::uint32_t Instance::flags() {
  follow_inputs();
  return flags_;
}

bool& Instance::force_control() {
  followed_ = false;
  return force_control_;
}

std::size_t Instance::state_size() const {
  return singles + inputs_.size() + angles_.size() + signals_.size() + skin_.state().size();
}

void Instance::save(std::span<double> state) const {
  state[place_of_mode] = static_cast<double>(mode_);
  state[place_of_time] = time_;
  state[place_of_control] = force_control_ ? 1 : 0;
  state[place_of_flags] = flags_;
  auto next = std::copy(inputs_.begin(), inputs_.end(), state.begin() + singles);
  next = std::copy(angles_.begin(), angles_.end(), next);
  next = std::copy(signals_.begin(), signals_.end(), next);
  std::copy(skin_.state().begin(), skin_.state().end(), next);
}

bool Instance::restore(std::span<const double> state) {
  if (state.size() != state_size()) {
    return false;
  }
  const auto is_count = [&](std::size_t place, double end) {
    return state[place] >= 0 && state[place] < end && std::trunc(state[place]) == state[place];
  };
  const auto own = state.first(state.size() - skin_.state().size());
  if (!is_count(place_of_mode, static_cast<double>(Mode::terminated) + 1) ||
      !is_count(place_of_control, 2) || !is_count(place_of_flags, flag::all + 1) ||
      !std::ranges::all_of(own, [](double value) { return std::isfinite(value); }) ||
      !trained(own[singles + reference::friction]) || !skin_.restore(state.subspan(own.size()))) {
    return false;
  }
  mode_ = static_cast<Mode>(static_cast<int>(state[place_of_mode]));
  time_ = state[place_of_time];
  force_control_ = state[place_of_control] != 0;
  flags_ = static_cast<std::uint32_t>(state[place_of_flags]);
  followed_ = false;
  auto take = [from = own.begin() + singles](auto& values) mutable {
    std::copy_n(from, values.size(), values.begin());
    from += static_cast<std::ptrdiff_t>(values.size());
  };
  take(inputs_);
  take(angles_);
  take(signals_);
  return true;
}

} // namespace ionskin::live::fmu
