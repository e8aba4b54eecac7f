// SPDX-License-Identifier: Apache-2.0
#include "ionskin/poroelasticity/prescribed_load.hpp"

#include "ionskin/case/elastic_constants.hpp"

#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

namespace ionskin::poroelasticity {
namespace {

/// Of a sine, which is linear between them: 1e-3 of its amplitude is lost.
constexpr int samples_per_period = 64;

using Samples = std::vector<std::pair<double, double>>; ///< time [s], share of the load [1]

Samples sine(const StrainSource& strain) {
  Samples samples;
  const double interval = 1 / (samples_per_period * strain.frequency);
  const auto share = [&](double time) {
    return std::sin(2 * std::numbers::pi * strain.frequency * time);
  };
  for (int i = 0; i * interval < strain.duration * (1 - 1e-9); ++i) {
    samples.emplace_back(i * interval, share(i * interval));
  }
  samples.emplace_back(strain.duration, share(strain.duration));
  return samples;
}

/// Of the whole load, at the bottom and at the top of the core [Pa].
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

std::vector<std::pair<double, double>> load_shares(const StrainSource& strain) {
  switch (strain.waveform) {
  case LoadWaveform::step:
    return {{0.0, 1.0}, {strain.duration, 1.0}};
  case LoadWaveform::ramp:
    if (strain.rise < strain.duration) {
      return {{0.0, 0.0}, {strain.rise, 1.0}, {strain.duration, 1.0}};
    }
    return {{0.0, 0.0}, {strain.duration, 1.0}};
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
  for (const auto& [time, share] : load_shares(input.strain)) {
    history.time.push_back(time);
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
