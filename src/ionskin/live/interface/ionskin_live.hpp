// SPDX-License-Identifier: Apache-2.0
#pragma once

/// C++17 interface of the reduced-order skin, for controllers: a header-only class around the C
/// interface, to be linked with libionskin_live. SI units.

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

/// Load of a step as a held height: that of the slider's underside above the undeformed top face,
/// negative when it indents [m].
struct Height {
  double value;
};
/// Load of a step as a held normal force on the skin, 0 for no contact [N].
struct Force {
  double value;
};

/// Result of a step: one value for each of `Skin::names()`, and the sum of flag bits such as
/// IONSKIN_LIVE_OUTSIDE_PLACE, 0 for a valid step within the trained range.
struct Signals {
  std::vector<double> values;
  std::uint32_t flags = 0;

  double operator[](std::size_t signal) const noexcept { return values[signal]; }
  /// True if the position, load, speed or pose was outside the trained range.
  bool outside() const noexcept {
    return (flags & (IONSKIN_LIVE_OUTSIDE_PLACE | IONSKIN_LIVE_OUTSIDE_LOAD |
                     IONSKIN_LIVE_OUTSIDE_SPEED | IONSKIN_LIVE_OUTSIDE_POSE)) != 0;
  }
};

/// Reduced-order skin with its state, stepped in real time. After construction, `step`, `save`,
/// `restore` and `reset` allocate nothing and throw nothing. One thread at a time may use a skin;
/// copies share the data of the file.
class Skin {
public:
  /// Opens a `.live` file, as a skin at rest without contact. Throws std::runtime_error, with the
  /// reason, when the file cannot be used.
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

  /// Names of the signals, in the order of `Signals::values`, as in signals.csv and taxels.csv.
  const std::vector<std::string>& names() const noexcept { return names_; }
  /// Index of a signal in `Signals::values`. Throws std::out_of_range when there is no signal of
  /// the name.
  std::size_t index(const std::string& name) const {
    for (std::size_t i = 0; i < names_.size(); ++i) {
      if (names_[i] == name) {
        return i;
      }
    }
    throw std::out_of_range("the skin has no signal " + name);
  }

  /// Advances the skin to an instant, with an upright slider at a position and at a given height or
  /// under a given force.
  /// @param time [s], not before that of the last step
  /// @param position of the slider's centre, x and y [m]
  /// @returns the signals, which the next step overwrites
  const Signals& step(double time, const std::array<double, 2>& position, Height height) noexcept {
    return step(time, position, {}, IONSKIN_LIVE_HEIGHT, height.value);
  }
  const Signals& step(double time, const std::array<double, 2>& position, Force force) noexcept {
    return step(time, position, {}, IONSKIN_LIVE_FORCE, force.value);
  }

  /// Advances the skin as the overloads above do, with a slider that is tilted and turned.
  /// @param angles roll, pitch and yaw [rad]
  const Signals& step(double time, const std::array<double, 2>& position,
                      const std::array<double, 3>& angles, Height height) noexcept {
    return step(time, position, angles, IONSKIN_LIVE_HEIGHT, height.value);
  }
  const Signals& step(double time, const std::array<double, 2>& position,
                      const std::array<double, 3>& angles, Force force) noexcept {
    return step(time, position, angles, IONSKIN_LIVE_FORCE, force.value);
  }

  /// Advances the skin with a slider that is held by a force and by moments about x and y, as
  /// `ionskin_live_step_held` does: roll and pitch follow.
  /// @param yaw [rad]
  /// @param moments about x and y [N m]
  const Signals& step_held(double time, const std::array<double, 2>& position, double yaw,
                           Force force, const std::array<double, 2>& moments) noexcept {
    signals_.flags = ionskin_live_step_held(handle_.get(), time, position[0], position[1], yaw,
                                            force.value, moments.data(), signals_.values.data());
    return signals_;
  }
  /// Roll, pitch and yaw that the last step took [rad].
  std::array<double, 3> angles() const noexcept {
    std::array<double, 3> values{};
    ionskin_live_angles(handle_.get(), values.data());
    return values;
  }

  /// Computes the derivative of the wrench at the end of the last step by a rigid motion of the
  /// slider, as `ionskin_live_stiffness` does.
  /// @param values receives [6 forces and moments][6 translations and rotations]
  /// @returns false, with NaN in all entries, if it is not known
  bool stiffness(std::array<double, 36>& values) noexcept {
    return ionskin_live_stiffness(handle_.get(), values.data()) != 0;
  }

  /// Computes the derivatives of the charges at the end of the last step by a rigid motion of the
  /// slider, as `ionskin_live_charge_derivatives` does.
  /// @param values receives [charge, as many as ionskin_live_charge_count(handle())][6 translations
  /// and rotations]
  /// @returns false, with NaN in all entries, if they are not known
  bool charge_derivatives(double* values) noexcept {
    return ionskin_live_charge_derivatives(handle_.get(), values) != 0;
  }

  /// Number of values of a state.
  std::size_t state_size() const noexcept { return ionskin_live_state_size(handle_.get()); }
  /// Copies the state, for `restore`.
  /// @param state receives the state [state_size()]
  void save(double* state) const noexcept { ionskin_live_save(handle_.get(), state); }
  /// Replaces the state by one that `save` copied from a skin of the same file. Time may go back by
  /// it.
  /// @param state [size]
  /// @returns false, with nothing changed, if no step can leave such a state: its size differs, or
  /// a number is not finite or out of range
  bool restore(const double* state, std::size_t size) noexcept {
    return ionskin_live_restore(handle_.get(), state, size) != 0;
  }
  /// Resets the state to that of a skin at rest without contact.
  void reset() noexcept { ionskin_live_reset(handle_.get()); }

  /// Sets the coefficient of friction, which is not part of the state. Allocates memory.
  /// @returns false, with nothing changed, if it is outside the trained range or memory is lacking
  bool set_friction(double coefficient) noexcept {
    return ionskin_live_set_friction(handle_.get(), coefficient) != 0;
  }
  /// Present coefficient of friction, then the lowest and the highest trained one.
  std::array<double, 3> friction() const noexcept {
    std::array<double, 3> values{};
    ionskin_live_friction(handle_.get(), values.data());
    return values;
  }

  /// Trained range: lowest x, y, highest x, y of the slider's centre [m], largest force [N],
  /// largest indentation [m], highest speed [m/s].
  std::array<double, 7> range() const noexcept {
    std::array<double, 7> values{};
    ionskin_live_range(handle_.get(), values.data());
    return values;
  }
  /// Trained range of poses: largest tilt [rad] and fastest rotation about z [rad/s], 0 for none;
  /// then 1 if the underside is rotationally symmetric about z, else 0.
  std::array<double, 3> pose_range() const noexcept {
    std::array<double, 3> values{};
    ionskin_live_pose_range(handle_.get(), values.data());
    return values;
  }
  /// Handle for functions of the C interface that this class does not wrap. The skin keeps
  /// ownership.
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
