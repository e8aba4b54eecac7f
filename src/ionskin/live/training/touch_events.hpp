// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace ionskin::live {

/// Events of a touch, in terms of contact state and path; also defined in docs/live-accuracy.md. An
/// instant may belong to several.
namespace event {
/// Contact that began less than `event_length` ago.
inline constexpr std::size_t landing = 0;
/// Onset of slip: begins when the slider in contact begins to slide or to rotate about z, or
/// changes direction by more than a right angle. It lasts until nothing of the contact sticks any
/// more, and at least `event_length`. Lift, rest or another onset end it.
inline constexpr std::size_t slip_onset = 1;
/// Rest in contact, in one pose and under an unchanged load, which has lasted for more than
/// `event_length`.
inline constexpr std::size_t hold = 2;
/// The last `event_length` of contact and the first `event_length` after it.
inline constexpr std::size_t lift = 3;
/// Load step: begins when the load in contact changes within a millisecond by more than
/// `least_load_step` of the largest load, and lasts until `event_length` after the last such
/// change. Instants of landing and lift do not belong to it.
inline constexpr std::size_t load_step = 4;
inline constexpr std::array<const char*, 5> names{"landing", "slip_onset", "hold", "lift",
                                                  "load_step"};
} // namespace event

/// Duration that the events are defined by, in instants, which are a millisecond apart.
inline constexpr std::size_t event_length = 50;
/// Smallest change of the load in a millisecond that is a load step, over the largest load [1].
inline constexpr double least_load_step = 0.02;

/// Path of the slider and contact of the full model at one instant.
struct TouchInstant {
  std::array<double, 2> centre{};       ///< of the slider, x and y [m]
  double load = 0;                      ///< of the path: force [N] or height [m]
  bool touches = false, sticks = false; ///< sticks: part of the contact does not slip
  std::array<double, 3> angles{};       ///< roll, pitch and yaw [rad]
};

/// Finds the events of each instant of a path.
/// @param instants a millisecond apart
/// @returns for each instant, bit i set for event i of `event::names`
std::vector<std::uint8_t> events_of(std::span<const TouchInstant> instants);

} // namespace ionskin::live
