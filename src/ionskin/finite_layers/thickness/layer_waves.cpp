// SPDX-License-Identifier: Apache-2.0
#include "ionskin/finite_layers/thickness/layer_waves.hpp"

#include <cmath>

namespace ionskin::finite_layers {
namespace {

/// Wave number times thickness, k t, below which a layer counts as thin [1].
constexpr double thin_layer = 0.5;

} // namespace

bool is_thin(const ElasticLayer& layer, double wave_number) {
  return wave_number * layer.thickness < thin_layer;
}

WaveColumns wave_displacement(const ElasticLayer& layer, double wave_number, double height) {
  const double k = wave_number, below = k * (height - layer.thickness), above = k * height;
  const double fall = std::exp(below), rise = std::exp(-above);
  const double kappa = 3 - 4 * layer.poissons_ratio();
  WaveColumns result;
  result << -fall, -rise, -below * fall, -above * rise, //
      fall, -rise, (below - kappa) * fall, (-above - kappa) * rise;
  return result;
}

WaveColumns wave_slope(const ElasticLayer& layer, double wave_number, double height) {
  const double k = wave_number, below = k * (height - layer.thickness), above = k * height;
  const double fall = std::exp(below), rise = std::exp(-above);
  const double kappa = 3 - 4 * layer.poissons_ratio();
  WaveColumns result;
  result << -fall, rise, -(1 + below) * fall, (above - 1) * rise, //
      fall, rise, (1 + below - kappa) * fall, (above + kappa - 1) * rise;
  return k * result;
}

WaveColumns wave_mean(const ElasticLayer& layer, double wave_number) {
  const double depth = wave_number * layer.thickness, kappa = 3 - 4 * layer.poissons_ratio();
  // Means of exp(-s) and of s exp(-s), s from 0 to the depth.
  const double plain = -std::expm1(-depth) / depth;
  const double linear = plain - std::exp(-depth);
  WaveColumns result;
  result << -plain, -plain, linear, -linear, //
      plain, -plain, -linear - kappa * plain, -linear - kappa * plain;
  return result;
}

WaveColumns wave_traction(const ElasticLayer& layer, double wave_number, double height) {
  const double k = wave_number, below = k * (height - layer.thickness), above = k * height;
  const double fall = std::exp(below), rise = std::exp(-above);
  const double nu = layer.poissons_ratio(), kappa = 3 - 4 * nu;
  WaveColumns result;
  result << -2 * fall, 2 * rise, (kappa - 1 - 2 * below) * fall, (kappa - 1 + 2 * above) * rise,
      2 * fall, 2 * rise, 2 * (below - 2 * (1 - nu)) * fall, 2 * (above + 2 * (1 - nu)) * rise;
  return layer.shear_modulus * k * result;
}

} // namespace ionskin::finite_layers
