// SPDX-License-Identifier: Apache-2.0
#include "ionskin/poroelasticity/prescribed_load.hpp"

#include "ionskin/case/elastic_constants.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <memory>
#include <numbers>

namespace ionskin::poroelasticity {
namespace {

/// Number of samples per period of a sine. Linear interpolation between them loses 1e-3 of its
/// amplitude.
constexpr int samples_per_period = 64;

LoadShares sine(const StrainSource& strain) {
  LoadShares load;
  const double interval = 1 / (samples_per_period * strain.frequency);
  const auto share = [&](double time) {
    return std::sin(2 * std::numbers::pi * strain.frequency * time);
  };
  for (int i = 0; i * interval < strain.duration * (1 - 1e-9); ++i) {
    load.time.push_back(i * interval);
  }
  load.time.push_back(strain.duration);
  std::ranges::transform(load.time, std::back_inserter(load.share), share);
  return load;
}

/// Undrained pore pressure under the whole load, at the bottom and at the top of the core [Pa].
std::array<double, 2> undrained_pressure(const Case& input) {
  const double storage = storage_modulus(input);
  if (input.strain.curvature == 0) {
    const double drained = drained_oedometric_modulus(input);
    const double pressure =
        (input.strain.pressure + drained * input.strain.compression / input.skin.core_thickness()) *
        storage / (drained + storage);
    return {pressure, pressure};
  }
  const double ratio = input.skin.layers[input.skin.core_index()].material.poissons_ratio;
  const double dilation =
      input.skin.sides == SideCondition::free ? 1 - 2 * ratio : (1 - 2 * ratio) / (1 - ratio);
  const double stretched =
      -storage * dilation * input.strain.curvature * 0.5 * input.skin.core_thickness();
  return {-stretched, stretched};
}

} // namespace

LoadShares load_shares(const StrainSource& strain) {
  switch (strain.waveform) {
  case LoadWaveform::step:
    return {{0.0, strain.duration}, {1.0, 1.0}};
  case LoadWaveform::ramp:
    if (strain.rise < strain.duration) {
      return {{0.0, strain.rise, strain.duration}, {0.0, 1.0, 1.0}};
    }
    return {{0.0, strain.duration}, {0.0, 1.0}};
  case LoadWaveform::sine:
    break;
  }
  return sine(strain);
}

history::CoreHistory prescribed_history(const Case& input) {
  history::CoreHistory history;
  history.measure = "prescribed";
  history.length = input.skin.length;
  history.width = input.skin.width;
  history.grid = {{0.0, history.length}, {0.0, history.width}, {0.0, input.skin.core_thickness()}};
  const std::array<double, 2> whole = undrained_pressure(input);
  auto& channel = history.add_channel(history::channel_name::undrained_pressure, "Pa");
  const LoadShares load = load_shares(input.strain);
  history.time = load.time;
  for (const double share : load.share) {
    channel.samples.push_back(std::make_shared<const history::StrainField>(
        history::StrainField{share * whole[0], share * whole[1]}));
  }
  history.event_time = {0.0};
  if (input.strain.waveform == LoadWaveform::ramp && input.strain.rise < input.strain.duration) {
    history.event_time.push_back(input.strain.rise);
  }
  return history;
}

} // namespace ionskin::poroelasticity
