// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/engine/onset_travel.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ionskin::mechanics {
namespace {

/// Share of the surface's displacement in full slip that is left when nothing sticks any more, at
/// most [1].
constexpr double negligible_onset = 1e-6;
/// Share of the surface's displacement in full slip that is left when an onset is over, at most
/// [1].
constexpr double end_of_onset = 1e-2;
/// Ratio of successive travel increments once all cells slip, larger than during the onset [1].
constexpr double growth_of_full_slip = 1.3;
/// Largest number of steps of a leg that is shorter than the onset.
constexpr int most_cuts_of_short_leg = 8;

} // namespace

void OnsetTravel::pass(const std::array<double, 2>& direction) {
  direction_ = direction;
  longest_ = std::numeric_limits<double>::infinity();
}

bool OnsetTravel::begin(const MotionLeg& leg, const SlidingContact& contact) {
  const auto direction = leg.direction();
  const double turn =
      std::acos(std::clamp(direction[0] * direction_[0] + direction[1] * direction_[1], -1.0, 1.0));
  const bool goes_on = direction_ != std::array<double, 2>{} && turn <= sharp_turn;
  direction_ = direction;
  if (goes_on) {
    return false;
  }
  const auto distance = contact.onset_distance(direction, half_model_, leg.length(), leg.duration);
  if (distance.left <= negligible_onset * distance.whole) {
    longest_ = std::numeric_limits<double>::infinity();
    return false;
  }
  const double total = (std::pow(steps_.onset_growth, steps_.onset) - 1) /
                       (steps_.onset_growth - 1); // of all increments over the first
  longest_ = steps_.onset_travel_ratio * distance.left / total;
  if (leg.length() < distance.left) {
    longest_ = std::max(longest_, leg.length() / most_cuts_of_short_leg);
  }
  return true;
}

void OnsetTravel::grow(const SlidingContact& contact) {
  longest_ *= contact.sticks() ? steps_.onset_growth : growth_of_full_slip;
}

bool OnsetTravel::is_over(const MotionLeg& leg, const SlidingContact& contact) const {
  if (contact.sticks()) {
    return false;
  }
  const auto distance = contact.onset_distance(direction_, half_model_, leg.length(), leg.duration);
  return distance.left <= end_of_onset * distance.whole;
}

} // namespace ionskin::mechanics
