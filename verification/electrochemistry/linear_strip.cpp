// SPDX-License-Identifier: Apache-2.0
#include "electrochemistry/linear_strip.hpp"

#include <cmath>
#include <numbers>

namespace ionskin::verification {

using Complex = LinearCell::Complex;

StripWaves::StripWaves(const Case& input, double length, std::size_t columns)
    : scales_(electrochemistry::derive_scales(input.electrochemistry, input.skin.core_thickness())),
      capacitance_unit_(input.electrochemistry.permittivity / scales_.debye_length),
      length_(length), columns_(columns) {}

Complex StripWaves::odd_waves(Complex s) const {
  const std::size_t last = columns_ > 0 ? columns_ : 4000;
  Complex sum = 0.0;
  for (std::size_t m = 1; m < last; m += 2) {
    const double phase = static_cast<double>(m) * std::numbers::pi;
    double wave = phase / length_, share = 2.0 / (phase * phase);
    if (columns_ > 0) {
      const auto count = static_cast<double>(columns_);
      const double sine = std::sin(0.5 * phase / count);
      wave = 2.0 * count / length_ * sine;
      share = 1.0 / (2.0 * count * count * sine * sine);
    }
    sum += share * capacitance(s, wave * scales_.debye_length);
  }
  return sum;
}

Complex StripWaves::capacitance(Complex s, double wave) const {
  const Complex p = s * scales_.relaxation_time, kappa = std::sqrt(1.0 + p + wave * wave);
  const double half = scales_.half_thickness, tanh = std::tanh(wave * half);
  const Complex decay = std::exp(-2.0 * kappa * half), layer = (1.0 - decay) / (1.0 + decay);
  const Complex rest = kappa * p / wave;
  const Complex odd = 1.0 / (layer + rest * tanh), even = 1.0 / (1.0 / layer + rest / tanh);
  return 0.5 * capacitance_unit_ * (1.0 + p) * kappa * (odd + even);
}

} // namespace ionskin::verification
