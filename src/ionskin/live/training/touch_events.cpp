// SPDX-License-Identifier: Apache-2.0
#include "ionskin/live/training/touch_events.hpp"

#include <algorithm>
#include <cmath>

namespace ionskin::live {
namespace {

// Changes within a millisecond up to which the slider counts as resting, as they are rounding
// errors: displacement [m], rotation about z [rad], change of the load over the largest load [1].
constexpr double way_of_rounding = 1e-12;
constexpr double turn_of_rounding = 1e-9;
constexpr double load_of_rounding = 1e-6;

/// Displacement of the slider's centre between two instants [m].
std::array<double, 2> way_between(const TouchInstant& from, const TouchInstant& to) {
  return {to.centre[0] - from.centre[0], to.centre[1] - from.centre[1]};
}

bool is_motion(const std::array<double, 2>& way) {
  return std::hypot(way[0], way[1]) > way_of_rounding;
}

bool turns(const TouchInstant& from, const TouchInstant& to) {
  return std::abs(to.angles[2] - from.angles[2]) > turn_of_rounding;
}

} // namespace

std::vector<std::uint8_t> events_of(std::span<const TouchInstant> instants) {
  std::vector<std::uint8_t> events(instants.size(), 0);
  const auto add = [&](std::size_t instant, std::size_t event) {
    events[instant] = static_cast<std::uint8_t>(events[instant] | 1u << event);
  };
  double largest = 0;
  for (const TouchInstant& instant : instants) {
    largest = std::max(largest, instant.touches ? std::abs(instant.load) : 0);
  }
  std::size_t landed = 0, rested = 0, onset = 0, loaded = 0; // instants since each began
  bool lands = false, slips = false, steps = false;          // true while the event may last
  for (std::size_t i = 1; i < instants.size(); ++i) {
    const TouchInstant &before = instants[i - 1], &now = instants[i];
    if (before.touches && !now.touches) {
      const std::size_t first = i - std::min(i, event_length),
                        last = std::min(instants.size(), i + event_length);
      for (std::size_t at = first; at < last; ++at) {
        add(at, event::lift);
      }
    }
    if (!now.touches) {
      lands = slips = steps = false;
      rested = 0;
      continue;
    }
    if (!before.touches) {
      lands = true;
      landed = 0;
    }
    if (lands && landed++ < event_length) {
      add(i, event::landing);
    }
    const auto moved = way_between(before, now);
    const bool spins = turns(before, now), moving = is_motion(moved) || spins;
    if (moving && before.touches) {
      const auto last = i > 1 ? way_between(instants[i - 2], before) : std::array<double, 2>{};
      const bool moved_last = is_motion(last) || (i > 1 && turns(instants[i - 2], before));
      if (!moved_last || moved[0] * last[0] + moved[1] * last[1] < 0) {
        slips = true;
        onset = 0;
      }
    }
    slips = slips && moving && (onset++ < event_length || now.sticks);
    if (slips) {
      add(i, event::slip_onset);
    }
    const bool rests = before.touches && !moving && now.angles == before.angles &&
                       std::abs(now.load - before.load) <= load_of_rounding * largest;
    if (before.touches && std::abs(now.load - before.load) > least_load_step * largest) {
      steps = true;
      loaded = 0;
    }
    if (steps && loaded++ < event_length) {
      add(i, event::load_step);
    }
    rested = rests ? rested + 1 : 0;
    if (rested > event_length) {
      add(i, event::hold);
    }
  }
  constexpr auto bit = [](std::size_t event) { return static_cast<std::uint8_t>(1u << event); };
  for (std::uint8_t& of_instant : events) {
    if ((of_instant & (bit(event::landing) | bit(event::lift))) != 0) {
      of_instant = static_cast<std::uint8_t>(of_instant & ~bit(event::load_step));
    }
  }
  return events;
}

} // namespace ionskin::live
