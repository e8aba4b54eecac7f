// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/live/channel_field.hpp"
#include "ionskin/live/charge_spread.hpp"
#include "ionskin/live/live_contact.hpp"
#include "ionskin/live/low_pass.hpp"
#include "ionskin/live/skin_data.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace ionskin::live {

/// Flags of a step by `Skin::step`, as bits; 0 where all is well.
namespace flag {
inline constexpr std::uint32_t outside_place = 1; ///< taken to the nearest trained place
inline constexpr std::uint32_t outside_load =
    2; ///< heavier or deeper than trained: the heaviest or deepest trained one was taken
inline constexpr std::uint32_t outside_speed = 4; ///< faster than trained
inline constexpr std::uint32_t unconverged = 8;   ///< residual above 1e-3: the step is a rough one
/// NaN, infinity, or a time before the last: nothing has moved, the signals are the last ones.
inline constexpr std::uint32_t refused = 16;
inline constexpr std::uint32_t pulled = 32; ///< a negative force: no skin pulls, it is detached
/// Steeper than trained, or turned about z though the underside does not turn into itself: the
/// nearest tilt that was trained, or no turn, was taken.
inline constexpr std::uint32_t outside_pose = 64;
inline constexpr std::uint32_t all = 2 * outside_pose - 1;
} // namespace flag

/// Largest yaw of a step: more turns than a slider makes, with digits left for a small one [rad].
inline constexpr double most_turned = 1e6;

/// The reduced skin: asked step by step where the slider is and how it presses, it tells forces,
/// charges and currents. After construction nothing is allocated and nothing is thrown. Each thread
/// takes a skin of its own; they may share the data, and copies share tables too.
class Skin {
public:
  /// @param data outlives this
  explicit Skin(const SkinData& data);

  /// Names of the signals, with those of signals.csv and taxels.csv [SI units].
  const std::vector<std::string>& names() const { return names_; }

  /// Steps the skin to an instant, with the slider at a place and a height or under a force.
  /// @param time [s]; of the first step any. Currents are means since the step before.
  /// @param place of the slider's centre [m]
  /// @param is_force whether `value` is the normal force of the whole skin [N], 0 or less for none,
  /// or the height of the underside above the undeformed top face [m], negative when it indents
  /// @param signals [names().size()]
  /// @returns flags
  std::uint32_t step(double time, const std::array<double, 2>& place, bool is_force, double value,
                     std::span<double> signals) noexcept {
    return step(time, place, Angles(), is_force, value, signals);
  }
  /// Roll, pitch and yaw, docs/model.md (77) [rad].
  using Angles = std::array<double, 3>;
  std::uint32_t step(double time, const std::array<double, 2>& place, const Angles& angles,
                     bool is_force, double value, std::span<double> signals) noexcept;

  /// Derivative of the last step's wrench on the whole skin by a motion of the slider,
  /// [forces along x, y, z, moments about x, y, z][ways along x, y, z, turns about x, y, z]:
  /// docs/model.md (80). Of a half skin, those by ways along y and turns about x and z are NaN.
  /// @returns false, and NaN, where no step led to this state, or the equations were not solved
  bool stiffness(std::span<double, 36> matrix) noexcept;

  /// Charges among the signals, in their order: of top, of bottom, of the top of each taxel.
  std::size_t charges() const { return sides + regions_ - 1; }
  /// Derivatives of the last step's charges by a motion of the slider, as `stiffness` has it:
  /// [charges()][motions] [C/m], [C/rad], docs/model.md (82). NaN where `stiffness` has it.
  /// @returns false, and NaN, where `stiffness` is not known
  bool charge_derivatives(std::span<double> matrix) noexcept;

  /// Sets another coefficient of friction, of the slider that touches now; it is not part of the
  /// state, and takes memory.
  /// @returns whether it is within the trained range; if not nothing changes
  bool set_friction(double coefficient);
  double friction() const { return contact_.friction(); }

  /// Back to a detached skin at rest.
  void reset() noexcept;
  /// All that passes from step to step.
  std::span<const double> state() const { return state_; }
  /// A step in two parts, between which others set the fields of several skins at once: `press`
  /// settles the contact, and `tell` takes a lane of the fields unless nothing touches.
  struct Pressed {
    std::uint32_t flags = 0;
    std::array<double, 2> place{}; ///< as used [m]
    double time_step = 0;          ///< [s]
    bool first = false, touches = false;
  };
  Pressed press(double time, const std::array<double, 2>& place, const Angles& angles,
                bool is_force, double value, std::span<double> signals) noexcept;
  void tell(const Pressed& pressed, std::span<const ChannelField> fields, std::size_t lane,
            std::span<double> signals) noexcept;
  /// Place and forces as `ChannelField::set` takes them.
  ChannelField::Touch touch(const Pressed& pressed) const noexcept;
  std::span<const ChannelField> fields() const { return fields_; }
  /// Exchanges state and friction with those of another skin of the same file, without memory.
  void exchange(std::vector<double>& state, laws::Friction& friction) noexcept;
  /// Takes up a state of a skin of the same file.
  /// @returns whether it is one that steps can leave: its size fits, every number is finite and in
  /// its range; if not nothing changes
  bool restore(std::span<const double> state) noexcept;

private:
  static constexpr std::size_t sides = 2; ///< of a region: top, bottom
  /// Places of single numbers in the state.
  enum Single : std::size_t {
    started,
    last_time,
    last_x,
    last_y,
    assembled_x,
    assembled_y,
    indentation,
    last_yaw,
    singles
  };

  // The state passes from step to step: skin_state.cpp.
  LiveContact::State contact_state() noexcept;
  bool may_be_state(std::span<const double> state) const noexcept;
  bool is_place(double x, double y) const noexcept;
  LiveContact::Stance stance(const Angles& angles, bool first, bool& outside) const noexcept;
  void add_contact(std::span<double> signals) noexcept;
  // These functions lead from the strain to the charges: skin_charges.cpp.
  template <class IntegrateTo> void set_levels(std::size_t levels, IntegrateTo&& to) noexcept;
  double drive(const ChargeModel& model, std::size_t region, const double* weights) const noexcept;
  void add_charges(double time_step, bool first) noexcept;
  void add_spread(const Pressed& pressed, std::span<const double> amplitude) noexcept;
  void set_field_levels(const ChannelField& field, std::size_t lane,
                        const std::array<double, 2>& place) noexcept;
  void set_charge_slopes(const ChannelField& field, std::size_t motion) noexcept;

  const SkinData& data_;
  LiveContact contact_;
  std::vector<std::string> names_;
  std::vector<double> state_;
  std::size_t force_ = 0, surface_ = 0, memory_ = 0, filters_ = 0, drives_ = 0, waves_ = 0,
              charges_ = 0, signals_ = 0;
  std::size_t regions_;
  /// Different corners of the core and of the taxels, and those of each region: x low and y low,
  /// high and low, low and high, both high.
  std::vector<std::array<double, 2>> corners_;
  std::vector<std::array<std::size_t, 4>> region_corners_;
  std::vector<double> region_share_; ///< of the core's area
  std::vector<ChannelField> fields_;
  ChargeSpread spread_;
  std::vector<double> corner_levels_; ///< [corner][level]
  std::vector<LowPass> passes_;       ///< of the rates over the step
  std::vector<double> levels_, charge_, pressure_, wave_drive_;
  Pressed last_;                     ///< the last step, for its derivatives
  std::vector<double> charge_slope_; ///< of each output by a motion
  std::vector<double> wave_slope_;   ///< of the drive of each wave by the place
};

} // namespace ionskin::live
