// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/live/channel_field.hpp"
#include "ionskin/live/charge_spread.hpp"
#include "ionskin/live/contact/live_contact.hpp"
#include "ionskin/live/data/skin_data.hpp"
#include "ionskin/live/low_pass.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace ionskin::live {

/// Bits of the flags that `Skin::step` returns; their sum is 0 for a valid step within the trained
/// range.
namespace flag {
/// Position outside the trained rectangle: the nearest position in it was used.
inline constexpr std::uint32_t outside_place = 1;
/// Force or indentation above the trained one, and the largest trained one was used; or a height
/// whose force exceeds the trained one.
inline constexpr std::uint32_t outside_load = 2;
inline constexpr std::uint32_t outside_speed = 4; ///< slide or spin faster than trained
/// Contact residual above 1e-3: the result is rough.
inline constexpr std::uint32_t unconverged = 8;
/// Step refused, as an input is NaN or infinite, the yaw exceeds `most_turned`, or the time is
/// before that of the last step. The state is unchanged, and the signals are those of the last
/// step.
inline constexpr std::uint32_t refused = 16;
/// Negative force given: the skin cannot pull, and the slider detaches.
inline constexpr std::uint32_t pulled = 32;
/// Tilt steeper than trained: the steepest trained one in that direction was used. Also a yaw of a
/// slider that was trained without turns and does not look alike from all sides: no yaw was used.
inline constexpr std::uint32_t outside_pose = 64;
/// All bits together.
inline constexpr std::uint32_t all = 2 * outside_pose - 1;
} // namespace flag

/// Largest magnitude of the yaw that a step accepts [rad]: more turns than a slider makes, while
/// double precision still resolves small changes.
inline constexpr double most_turned = 1e6;

/// Reduced-order model of a skin, stepped in real time: each step takes the position and load of
/// the slider, and returns forces, charges and currents. No function allocates or throws after
/// construction, except `set_friction`. One thread at a time may use a `Skin`; several may share
/// one `SkinData`, and copies share tables too.
class Skin {
public:
  /// Makes a skin at rest without contact.
  /// @param data the trained model; must outlive the skin
  explicit Skin(const SkinData& data);

  /// Names of the signals, in the order in which a step writes them, as in signals.csv and
  /// taxels.csv; all signals are in SI units.
  const std::vector<std::string>& names() const { return names_; }

  /// Advances the skin to an instant, with the slider at a position and at a given height or under
  /// a given force. The first overload takes an upright slider.
  /// @param time [s], not before that of the last step; any at the first step. Currents are means
  /// over the time since the last step.
  /// @param place position of the slider's centre along x and y [m]
  /// @param is_force true if `value` is the normal force on the whole skin [N], with 0 or less for
  /// no contact; false if it is the height of the lowest point of the underside above the
  /// undeformed top face [m], negative when it indents
  /// @param signals receives the signals, in the order of `names()` [names().size()]
  /// @returns sum of the bits in `flag`, 0 for a valid step
  std::uint32_t step(double time, const std::array<double, 2>& place, bool is_force, double value,
                     std::span<double> signals) noexcept {
    return step(time, place, Angles(), is_force, value, signals);
  }
  /// Roll, pitch and yaw of the slider, docs/model.md (77) [rad].
  using Angles = std::array<double, 3>;
  /// Advances the skin as the overload above does, with a slider that is tilted and turned.
  /// @param angles roll, pitch and yaw of the slider [rad]
  std::uint32_t step(double time, const std::array<double, 2>& place, const Angles& angles,
                     bool is_force, double value, std::span<double> signals) noexcept;
  /// Advances the skin with a slider that is held by a force and by two moments, such as a finger
  /// on a hinge: roll and pitch follow from the moments, docs/model.md (79). The search for them
  /// starts from the pose of the last step.
  /// @param yaw of the slider [rad]
  /// @param force normal force on the whole skin [N], 0 or less for no contact; the tilt of the
  /// last step then stays
  /// @param moments about x and y of the forces on the skin, about the slider's centre on the
  /// undeformed top face [N m]; met to 1e-3 of the force times the reach of the contact cells.
  /// Where a steeper tilt than trained would be needed, the flag `outside_pose` is set.
  std::uint32_t step_held(double time, const std::array<double, 2>& place, double yaw, double force,
                          const std::array<double, 2>& moments, std::span<double> signals) noexcept;
  /// Roll, pitch and yaw that the last step took [rad].
  Angles angles() const { return {state_[last_roll], state_[last_pitch], state_[last_yaw]}; }

  /// Computes the derivative of the wrench on the whole skin, at the end of the last step, by a
  /// rigid motion of the slider, docs/model.md (80). Of a skin that is modelled as one symmetric
  /// half, the derivatives by translation along y and rotation about x and z are unknown, and NaN.
  /// @param matrix receives [forces along x, y, z (N), moments about x, y, z (N m)][translations
  /// along x, y, z (m), rotations about x, y, z (rad)]
  /// @returns true, with zeros if nothing touches; false, with all entries NaN, if no step led to
  /// the present state or the equations were not solved
  bool stiffness(std::span<double, 36> matrix) noexcept;

  /// Number of charges among the signals, which are, in this order, those of the top electrode, of
  /// the bottom electrode, and of each taxel on top.
  std::size_t charges() const { return sides + regions_ - 1; }
  /// Computes the derivatives of the charges, at the end of the last step, by the rigid motions of
  /// the slider that `stiffness` describes, docs/model.md (82). Entries are NaN for the motions for
  /// which those of `stiffness` are.
  /// @param matrix receives [charge][motion] [C/m] for translations, [C/rad] for rotations;
  /// charges() * 6 numbers
  /// @returns true or false, with all entries NaN, as `stiffness` does
  bool charge_derivatives(std::span<double> matrix) noexcept;

  /// Sets the coefficient of friction [1] of the next steps. The coefficient is not part of the
  /// state. Allocates memory.
  /// @returns false, with nothing changed, if it is outside the trained range
  bool set_friction(double coefficient);
  /// Coefficient of friction of the next step [1].
  double friction() const { return contact_.friction(); }

  /// Resets the state to that of a skin at rest without contact.
  void reset() noexcept;
  /// State that passes from step to step, for `restore`. Its memory belongs to the skin.
  std::span<const double> state() const { return state_; }
  /// Result of the first part of a step, `press`, for the second part, `tell`. A step has two parts
  /// so that the strain fields of several skins can be computed together in between: `press` solves
  /// the contact, and `tell` computes the charges from one lane of the fields.
  struct Pressed {
    std::uint32_t flags = 0;
    std::array<double, 2> place{}; ///< slider's centre, moved into the trained rectangle [m]
    double time_step = 0;          ///< since the last step; 0 at the first [s]
    /// True of the first step after a reset; true if any cell of the contact carries force.
    bool first = false, touches = false;
  };
  /// First part of a step: checks the inputs, solves the contact, and writes the signals of motion
  /// and contact. The parameters are those of `step`.
  Pressed press(double time, const std::array<double, 2>& place, const Angles& angles,
                bool is_force, double value, std::span<double> signals) noexcept;
  /// Second part of a step, not to be called for a refused step: integrates the strain fields,
  /// updates the charges, and writes the remaining signals.
  /// @param pressed result of `press`
  /// @param fields of the channels, which hold the touch of this skin in `lane`; their values are
  /// not used if nothing touches
  void tell(const Pressed& pressed, std::span<const ChannelField> fields, std::size_t lane,
            std::span<double> signals) noexcept;
  /// Position and cell forces of a step, as `ChannelField::set` takes them. The forces are a view
  /// of the state.
  ChannelField::Touch touch(const Pressed& pressed) const noexcept;
  /// Fields of the channels of the core, in the order of `SkinData::channels`.
  std::span<const ChannelField> fields() const { return fields_; }
  /// Swaps state and friction law with another skin of the same file, without allocating.
  /// @param state [state().size()]
  void exchange(std::vector<double>& state, laws::Friction& friction) noexcept;
  /// Replaces the state by one that `state` returned for a skin of the same file.
  /// @returns false, with nothing changed, if no step can leave such a state: its size differs, or
  /// a number is not finite or out of range
  bool restore(std::span<const double> state) noexcept;

private:
  static constexpr std::size_t sides = 2; ///< electrodes of a region: top, bottom
  /// Indices of the single numbers at the beginning of the state.
  enum Single : std::size_t {
    started,
    last_time,
    last_x,
    last_y,
    assembled_x,
    assembled_y,
    indentation,
    last_yaw,
    last_roll,
    last_pitch,
    singles
  };

  // State handling, in skin_state.cpp.
  LiveContact::State contact_state() noexcept;
  bool may_be_state(std::span<const double> state) const noexcept;
  bool is_place(double x, double y) const noexcept;
  LiveContact::Stance stance(Angles& angles, bool first, bool& outside) const noexcept;
  Pressed press_again(double time, const std::array<double, 2>& place, const Angles& angles,
                      double force, std::span<double> signals) noexcept;
  std::uint32_t finish(const Pressed& pressed, std::span<double> signals) noexcept;
  void add_contact(std::span<double> signals) noexcept;
  // Charges from the strain, in skin_charges.cpp.
  template <class IntegrateTo> void set_levels(std::size_t levels, IntegrateTo&& to) noexcept;
  double drive(const ChargeModel& model, std::size_t region, const double* weights) const noexcept;
  void add_charges(double time_step, bool first) noexcept;
  void add_spread(const Pressed& pressed, std::span<const double> amplitude) noexcept;
  void set_field_levels(const ChannelField& field, std::size_t lane,
                        const std::array<double, 2>& place) noexcept;
  void set_charge_slopes(const ChannelField& field, std::size_t motion) noexcept;

  const SkinData& data_;
  double reach_;           ///< of the contact cells from the slider's centre [m]
  double place_tolerance_; ///< distance from the trained positions that does not count [m]
  LiveContact contact_;
  std::vector<std::string> names_;
  std::vector<double> state_,
      before_; ///< the second of a step under held moments, at its beginning
  /// Offsets of the parts of the state: cell forces, surface displacements, memory of friction,
  /// states and last drives of the charges, waves, charges of the last step that took time, and
  /// signals of the last step.
  std::size_t force_ = 0, surface_ = 0, memory_ = 0, filters_ = 0, drives_ = 0, waves_ = 0,
              charges_ = 0, signals_ = 0;
  std::size_t regions_; ///< number of regions: the core and the taxels
  /// Distinct corners of the core and of the taxels, x and y [m].
  std::vector<std::array<double, 2>> corners_;
  /// Indices in `corners_` of the corners of each region: low x and low y, high and low, low and
  /// high, high and high. Region 0 is the core; the taxels follow.
  std::vector<std::array<std::size_t, 4>> region_corners_;
  /// Area of each region over the area of the core [1].
  std::vector<double> region_share_;
  std::vector<ChannelField> fields_;
  ChargeSpread spread_;
  std::vector<double> corner_levels_; ///< integrals of a channel up to each corner [corner][level]
  std::vector<LowPass> passes_;       ///< low-pass weights of the step [rate]
  /// Work arrays: integrals of a channel [region][level], charges [region][top, bottom] [C],
  /// pressures of the cells [Pa], drives of the waves [C].
  std::vector<double> levels_, charge_, pressure_, wave_drive_;
  Pressed last_; ///< last step, for the derivatives
  /// Derivative of the charge of each output by one motion [region][top, bottom] [C/m], [C/rad].
  std::vector<double> charge_slope_;
  std::vector<double> wave_slope_; ///< derivative of the drive of each wave by the position
};

} // namespace ionskin::live
