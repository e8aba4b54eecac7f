// SPDX-License-Identifier: Apache-2.0
#include "ionskin/live/batch/skins.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>

namespace ionskin::live {
namespace {

/// Scrambles the bits of a number, by a step of SplitMix64 (Steele, Lea and Flood 2014,
/// doi 10.1145/2660193.2660195).
std::uint64_t mixed(std::uint64_t value) noexcept {
  value += 0x9e3779b97f4a7c15;
  value = (value ^ value >> 30) * 0xbf58476d1ce4e5b9;
  value = (value ^ value >> 27) * 0x94d049bb133111eb;
  return value ^ value >> 31;
}

/// Uniformly distributed number in (0, 1), made of random bits.
double uniform(std::uint64_t bits) noexcept {
  return (static_cast<double>(bits >> 11) + 0.5) * 0x1p-53;
}

/// Random number of the standard normal distribution (Box and Muller 1958, doi
/// 10.1214/aoms/1177706645), which depends only on the arguments.
/// @param seed, step of the noise
/// @param place index of the signal
double normal(std::uint64_t seed, std::uint64_t step, std::uint64_t place) noexcept {
  const std::uint64_t key = mixed(mixed(mixed(seed) ^ step) ^ place);
  return std::sqrt(-2 * std::log(uniform(mixed(key)))) *
         std::cos(2 * std::numbers::pi * uniform(mixed(key + 1)));
}

} // namespace

Skins::Skins(const SkinData& data, const Skin& like, std::size_t environments, std::size_t workers)
    : data_(data), frictions_(environments, friction_of(data, like.friction())),
      noises_(environments) {
  const std::vector<std::string>& names = like.names();
  const auto place = [&](std::string_view name) {
    return static_cast<std::size_t>(std::ranges::find(names, name) - names.begin());
  };
  sums_ = {place("current_top"), place("current_bottom"), place("current_difference"),
           place("current_common")};
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i].starts_with("current_") && i != sums_[2] && i != sums_[3]) {
      noisy_.push_back(i);
    }
  }
  states_.assign(environments, {like.state().begin(), like.state().end()});
  Skin rested = like;
  rested.reset();
  rest_.assign(rested.state().begin(), rested.state().end());
  for (std::size_t i = 0; i < std::max<std::size_t>(1, workers); ++i) {
    workers_.push_back({std::vector<Skin>(most_lanes, rested),
                        {rested.fields().begin(), rested.fields().end()},
                        std::vector<double>(most_lanes * names.size())});
  }
}

void Skins::reset(std::size_t environment) noexcept {
  std::ranges::copy(rest_, states_[environment].begin());
}

bool Skins::restore(std::size_t environment, std::span<const double> state) noexcept {
  Skin& judge = workers_.front().lanes.front();
  if (!judge.restore(state)) {
    return false;
  }
  judge.restore(rest_);
  std::ranges::copy(state, states_[environment].begin());
  return true;
}

bool Skins::set_friction(std::size_t environment, double coefficient) {
  if (!(coefficient >= data_.lowest_friction && coefficient <= data_.highest_friction)) {
    return false;
  }
  frictions_[environment] = friction_of(data_, coefficient);
  return true;
}

/// Adds the noise of a step to the currents, and recomputes half their difference and half their
/// sum.
/// @param refused true if the step was refused: it repeats the signals of the last step, and so the
/// noise of the last step
void Skins::add_noise(std::size_t environment, bool refused, std::span<double> signals) noexcept {
  CurrentNoise& noise = noises_[environment];
  if (noise.deviation == 0 || (refused && noise.steps == 0)) {
    return;
  }
  noise.steps -= refused ? 1 : 0;
  for (const std::size_t place : noisy_) {
    signals[place] += noise.deviation * normal(noise.seed, noise.steps, place);
  }
  const double top = signals[sums_[0]], bottom = signals[sums_[1]];
  signals[sums_[2]] = (top - bottom) / 2;
  signals[sums_[3]] = (top + bottom) / 2;
  ++noise.steps;
}

template <class Value>
void Skins::step(std::size_t worker, std::size_t first, std::size_t last,
                 const Step<Value>& step) noexcept {
  Worker& own = workers_[worker];
  const std::size_t size = names().size();
  for (; first < last; first += most_lanes) {
    const std::size_t lanes = std::min(most_lanes, last - first);
    std::array<Skin::Pressed, most_lanes> pressed;
    std::array<ChannelField::Touch, most_lanes> touches;
    std::array<std::size_t, most_lanes> lane_of{};
    std::size_t touching = 0;
    const auto signals = [&](std::size_t lane) {
      return std::span(own.signals).subspan(lane * size, size);
    };
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      const std::size_t at = first + lane;
      Skin& skin = own.lanes[lane];
      skin.exchange(states_[at], frictions_[at]);
      Skin::Angles angles{};
      for (std::size_t i = 0; step.angles != nullptr && i < angles.size(); ++i) {
        angles[i] = static_cast<double>(step.angles[angles.size() * at + i]);
      }
      pressed[lane] =
          skin.press(step.times[at],
                     {static_cast<double>(step.positions[2 * at]),
                      static_cast<double>(step.positions[2 * at + 1])},
                     angles, step.is_force, static_cast<double>(step.loads[at]), signals(lane));
      if (step.stiffness != nullptr) {
        skin.stiffness(std::span<double, 36>(step.stiffness + 36 * at, 36));
      }
      if (pressed[lane].touches) {
        lane_of[lane] = touching;
        touches[touching++] = skin.touch(pressed[lane]);
      }
    }
    for (ChannelField& field : own.fields) {
      if (touching > 0) {
        field.set(std::span(touches).first(touching));
      }
    }
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      const std::size_t at = first + lane;
      Skin& skin = own.lanes[lane];
      const bool refused = (pressed[lane].flags & flag::refused) != 0;
      if (!refused) {
        skin.tell(pressed[lane], own.fields, lane_of[lane], signals(lane));
      }
      skin.exchange(states_[at], frictions_[at]);
      add_noise(at, refused, signals(lane));
      for (std::size_t i = 0; i < step.columns.size(); ++i) {
        step.signals[at * step.columns.size() + i] =
            static_cast<Value>(signals(lane)[step.columns[i]]);
      }
      step.flags[at] = pressed[lane].flags;
    }
  }
}

template void Skins::step(std::size_t, std::size_t, std::size_t, const Step<float>&) noexcept;
template void Skins::step(std::size_t, std::size_t, std::size_t, const Step<double>&) noexcept;

} // namespace ionskin::live
