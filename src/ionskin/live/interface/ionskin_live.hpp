// SPDX-License-Identifier: Apache-2.0
#pragma once

/// The reduced skin for controllers in C++17 and later: a class around the C interface, header
/// only, to be linked with libionskin_live. SI units.

#include <ionskin_live.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

namespace ionskin_live {

/// Height of the slider's underside above the undeformed top face, negative when it indents [m].
struct Height {
  double value;
};
/// Normal force, 0 for none [N].
struct Force {
  double value;
};

/// Result of a step: a value for each of `Skin::names()`, and flags, 0 where all is well
/// (IONSKIN_LIVE_OUTSIDE_PLACE and the others).
struct Signals {
  std::vector<double> values;
  std::uint32_t flags = 0;

  double operator[](std::size_t signal) const noexcept { return values[signal]; }
  /// True if a step lies outside the trained range, in place, load, speed or pose.
  bool outside() const noexcept {
    return (flags & (IONSKIN_LIVE_OUTSIDE_PLACE | IONSKIN_LIVE_OUTSIDE_LOAD |
                     IONSKIN_LIVE_OUTSIDE_SPEED | IONSKIN_LIVE_OUTSIDE_POSE)) != 0;
  }
};

/// A reduced skin. After construction `step`, `save`, `restore` and `reset` take no memory and
/// throw nothing. One thread at a time steps it; copies share what the file holds.
class Skin {
public:
  /// Throws std::runtime_error, with the reason, when the file cannot be used.
  explicit Skin(const std::string& path) : handle_(open(path), ionskin_live_close) { take_names(); }
  /// Makes another skin of the same file in the same state. Throws std::bad_alloc.
  Skin(const Skin& other)
      : handle_(ionskin_live_copy(other.handle_.get()), ionskin_live_close), names_(other.names_),
        signals_(other.signals_) {
    if (handle_ == nullptr) {
      throw std::bad_alloc();
    }
  }
  Skin(Skin&&) noexcept = default;
  Skin& operator=(Skin&&) noexcept = default;
  Skin& operator=(const Skin& other) { return *this = Skin(other); }
  ~Skin() = default;

  /// Names of the signals, as in signals.csv and taxels.csv.
  const std::vector<std::string>& names() const noexcept { return names_; }
  /// Place of a signal. Throws std::out_of_range when there is none of the name.
  std::size_t index(const std::string& name) const {
    for (std::size_t i = 0; i < names_.size(); ++i) {
      if (names_[i] == name) {
        return i;
      }
    }
    throw std::out_of_range("the skin has no signal " + name);
  }

  /// Steps the skin to an instant, with the slider at a place and a height or under a force.
  /// @param time [s], that of the last step or later
  /// @param position of the slider's centre [m]
  /// @returns the signals, which the next step replaces
  const Signals& step(double time, const std::array<double, 2>& position, Height height) noexcept {
    return step(time, position, {}, IONSKIN_LIVE_HEIGHT, height.value);
  }
  const Signals& step(double time, const std::array<double, 2>& position, Force force) noexcept {
    return step(time, position, {}, IONSKIN_LIVE_FORCE, force.value);
  }

  /// Steps as `step` does a slider that is tilted and turned.
  /// @param angles roll, pitch and yaw [rad]
  const Signals& step(double time, const std::array<double, 2>& position,
                      const std::array<double, 3>& angles, Height height) noexcept {
    return step(time, position, angles, IONSKIN_LIVE_HEIGHT, height.value);
  }
  const Signals& step(double time, const std::array<double, 2>& position,
                      const std::array<double, 3>& angles, Force force) noexcept {
    return step(time, position, angles, IONSKIN_LIVE_FORCE, force.value);
  }

  /// Derivative of the last step's wrench by a rigid motion of the slider, as
  /// `ionskin_live_stiffness` tells it [6 forces and moments][6 ways and turns].
  /// @returns whether it is known; if not it is NaN
  bool stiffness(std::array<double, 36>& values) noexcept {
    return ionskin_live_stiffness(handle_.get(), values.data()) != 0;
  }

  /// Derivatives of the last step's charges by a rigid motion of the slider, as
  /// `ionskin_live_charge_derivatives` tells them: [signals whose names begin with charge_][6 ways
  /// and turns].
  /// @param values [ionskin_live_charge_count(handle())][6]
  /// @returns whether they are known; if not they are NaN
  bool charge_derivatives(double* values) noexcept {
    return ionskin_live_charge_derivatives(handle_.get(), values) != 0;
  }

  /// Numbers of a state.
  std::size_t state_size() const noexcept { return ionskin_live_state_size(handle_.get()); }
  /// Copies the state, for `restore`. @param state [state_size()]
  void save(double* state) const noexcept { ionskin_live_save(handle_.get(), state); }
  /// Takes up a state of a skin of the same file, kept in `size` numbers; time may go back by it.
  /// @returns whether it is one: its size fits, and every number is finite and within what a step
  /// can leave; if not nothing changes
  bool restore(const double* state, std::size_t size) noexcept {
    return ionskin_live_restore(handle_.get(), state, size) != 0;
  }
  /// Back to a detached skin at rest.
  void reset() noexcept { ionskin_live_reset(handle_.get()); }

  /// Sets another coefficient of friction, which is not part of the state. Takes memory.
  /// @returns whether it is within the trained range; if not nothing changes
  bool set_friction(double coefficient) noexcept {
    return ionskin_live_set_friction(handle_.get(), coefficient) != 0;
  }
  /// The present coefficient of friction, the lowest and the highest that were trained.
  std::array<double, 3> friction() const noexcept {
    std::array<double, 3> values{};
    ionskin_live_friction(handle_.get(), values.data());
    return values;
  }

  /// Trained: lowest x, y, highest x, y [m], force [N], indentation [m], speed [m/s].
  std::array<double, 7> range() const noexcept {
    std::array<double, 7> values{};
    ionskin_live_range(handle_.get(), values.data());
    return values;
  }
  /// Trained: tilt [rad] and turn about z [rad/s]; and 1 if the underside turns into itself.
  std::array<double, 3> pose_range() const noexcept {
    std::array<double, 3> values{};
    ionskin_live_pose_range(handle_.get(), values.data());
    return values;
  }
  /// Handle of the C interface, for what this class has no function.
  ionskin_live_skin* handle() const noexcept { return handle_.get(); }

private:
  static ionskin_live_skin* open(const std::string& path) {
    std::array<char, 4096> message{};
    ionskin_live_skin* skin = ionskin_live_open(path.c_str(), message.data(), message.size());
    if (skin == nullptr) {
      throw std::runtime_error(message.data());
    }
    return skin;
  }
  void take_names() {
    const std::size_t count = ionskin_live_signal_count(handle_.get());
    for (std::size_t i = 0; i < count; ++i) {
      names_.emplace_back(ionskin_live_signal_name(handle_.get(), i));
    }
    signals_.values.resize(count);
  }
  const Signals& step(double time, const std::array<double, 2>& position,
                      const std::array<double, 3>& angles, int kind, double value) noexcept {
    signals_.flags = ionskin_live_step_posed(handle_.get(), time, position[0], position[1],
                                             angles.data(), kind, value, signals_.values.data());
    return signals_;
  }

  std::unique_ptr<ionskin_live_skin, void (*)(ionskin_live_skin*)> handle_;
  std::vector<std::string> names_;
  Signals signals_;
};

} // namespace ionskin_live
