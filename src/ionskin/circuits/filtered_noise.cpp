// SPDX-License-Identifier: Apache-2.0
#include "ionskin/circuits/filtered_noise.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ionskin::circuits {

FilteredNoise::FilteredNoise(double density, double bandwidth, std::uint64_t seed)
    : time_constant_(0.5 / (std::numbers::pi * bandwidth)),
      deviation_(density * std::sqrt(0.5 * std::numbers::pi * bandwidth)), generator_(seed) {
  value_ = deviation_ * normal();
}

// Draws a number of the normal distribution by the method of Box and Muller (1958, doi
// 10.1214/aoms/1177706645): the distribution of the standard library differs between its
// implementations.
double FilteredNoise::normal() {
  if (spare_) {
    const double value = *spare_;
    spare_.reset();
    return value;
  }
  const auto uniform = [this] {
    return (static_cast<double>(generator_() >> 11) + 0.5) * 0x1p-53; // within (0, 1)
  };
  const double radius = std::sqrt(-2.0 * std::log(uniform()));
  const double angle = 2.0 * std::numbers::pi * uniform();
  spare_ = radius * std::sin(angle);
  return radius * std::cos(angle);
}

double FilteredNoise::advance(double duration) {
  const double h = duration / time_constant_;
  const double decay = -std::expm1(-h);
  const double value_variance = -std::expm1(-2.0 * h);
  // 2 h - 2 decay - decay^2 cancels for short steps.
  const double integral_variance =
      h < 1e-3 ? h * h * h * (2.0 / 3.0 - 0.5 * h) : 2.0 * h - 2.0 * decay - decay * decay;
  const double covariance = decay * decay;
  const double first = normal(), second = normal();
  const double spread = std::sqrt(value_variance);
  const double rest = std::max(0.0, integral_variance - covariance * covariance / value_variance);
  const double integral =
      time_constant_ *
      (value_ * decay + deviation_ * (covariance / spread * first + std::sqrt(rest) * second));
  value_ += deviation_ * spread * first - value_ * decay;
  return integral;
}

} // namespace ionskin::circuits
