// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace ionskin::live {

/// Events of a touch, by the contact's state and the path; docs/live.md says the same. An instant
/// may belong to several.
namespace event {
/// The slider touches, and did not so long before.
inline constexpr std::size_t landing = 0;
/// The slider begins to move along the skin in contact or to spin, or turns by more than a right
/// angle: from then until nothing of the contact sticks any more, and so long at least. Lift, rest
/// or another onset end it.
inline constexpr std::size_t slip_onset = 1;
/// The slider rests in contact, in its pose, under an unchanged load, and did so for so long.
inline constexpr std::size_t hold = 2;
/// The slider leaves the skin in so long, or left it so long before.
inline constexpr std::size_t lift = 3;
inline constexpr std::array<const char*, 4> names{"landing", "slip_onset", "hold", "lift"};
} // namespace event

/// Length that the events are defined by, in instants a millisecond apart.
inline constexpr std::size_t event_length = 50;

/// Path and contact of the full model at an instant.
struct TouchInstant {
  std::array<double, 2> centre{};       ///< of the slider [m]
  double load = 0;                      ///< of the path: force [N] or height [m]
  bool touches = false, sticks = false; ///< sticks: some part of the contact does not slip
  std::array<double, 3> angles{};       ///< roll, pitch and yaw [rad]
};

/// Events of each instant of a path, a millisecond apart, as bits by their places in the names.
std::vector<std::uint8_t> events_of(std::span<const TouchInstant> instants);

} // namespace ionskin::live
