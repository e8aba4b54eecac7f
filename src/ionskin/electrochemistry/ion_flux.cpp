// SPDX-License-Identifier: Apache-2.0
#include "ionskin/electrochemistry/ion_flux.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace ionskin::electrochemistry {
namespace {

/// Below this |x| the Taylor series (remainder under 1e-17) replaces the formula, which cancels
/// there.
constexpr double series_limit = 0.1;

inline double value_series(double x) {
  const double x2 = x * x;
  return 1.0 - 0.5 * x +
         x2 * (1.0 / 12.0 - x2 * (1.0 / 720.0 - x2 * (1.0 / 30240.0 - x2 / 1209600.0)));
}

inline double derivative_series(double x) {
  const double x2 = x * x;
  return -0.5 + x * (1.0 / 6.0 - x2 * (1.0 / 180.0 - x2 * (1.0 / 5040.0 - x2 / 151200.0)));
}

/// B from x and exp(x).
inline double value_of(double x, double exponential) {
  const bool small = std::abs(x) < series_limit;
  const double formula = x / (small ? 1.0 : exponential - 1.0);
  return small ? value_series(x) : formula;
}

/// B' = B (1 - B - x) / x, which follows from exp(x) = 1 + x / B.
inline double derivative_of(double x, double value) {
  const bool small = std::abs(x) < series_limit;
  const double formula = value * (1.0 - value - x) / (small ? 1.0 : x);
  return small ? derivative_series(x) : formula;
}

/// exp(x) for |x| <= 700 to 2e-16, as 2^n times the Taylor series of the rest. Unlike a library's,
/// it is compiled into the loops below, so that every element is rounded alike wherever it stands
/// in a row.
inline double exponential(double x) {
  constexpr double shifter = 0x1.8p52; // adding it rounds to an integer in the lowest bits
  constexpr double ln2_high = 0x1.62e42fefa0000p-1, ln2_low = 0x1.cf79abc9e3b3ap-40;
  const double shifted = x * std::numbers::log2e + shifter;
  const double n = shifted - shifter;
  const double r = (x - n * ln2_high) - n * ln2_low;
  double series = 1.0 / 6227020800.0; // 1 / 13!
  for (const double coefficient :
       {1.0 / 479001600.0, 1.0 / 39916800.0, 1.0 / 3628800.0, 1.0 / 362880.0, 1.0 / 40320.0,
        1.0 / 5040.0, 1.0 / 720.0, 1.0 / 120.0, 1.0 / 24.0, 1.0 / 6.0, 0.5, 1.0, 1.0}) {
    series = series * r + coefficient;
  }
  const std::uint64_t power = (std::bit_cast<std::uint64_t>(shifted) << 52) + (1023ULL << 52);
  return series * std::bit_cast<double>(power);
}

/// Differences of potential beyond this leave no flux against the field in double precision.
constexpr double largest_difference = 700.0;

} // namespace

Bernoulli bernoulli(double x) {
  const double value =
      value_of(x, exponential(std::clamp(x, -largest_difference, largest_difference)));
  return {value, derivative_of(x, value)};
}

void ThicknessFlux::exponentials(std::span<const double> potential_lower,
                                 std::span<const double> potential_upper) {
  double* result = exponential_.data();
  const std::size_t columns = exponential_.size();
#pragma omp simd
  for (std::size_t i = 0; i < columns; ++i) {
    const double u = potential_upper[i] - potential_lower[i];
    result[i] = exponential(std::min(std::max(u, -largest_difference), largest_difference));
  }
}

void ThicknessFlux::evaluate(std::span<const double> concentration_lower,
                             std::span<const double> concentration_upper,
                             std::span<const double> potential_lower,
                             std::span<const double> potential_upper, double spacing,
                             std::span<double> flux) {
  exponentials(potential_lower, potential_upper);
  const double inverse_spacing = 1.0 / spacing;
  const std::size_t columns = exponential_.size();
#pragma omp simd
  for (std::size_t i = 0; i < columns; ++i) {
    const double u = potential_upper[i] - potential_lower[i];
    const double b = value_of(u, exponential_[i]);
    flux[i] = inverse_spacing * (b * concentration_lower[i] - (b + u) * concentration_upper[i]);
  }
}

void ThicknessFlux::derivatives(std::span<const double> concentration_lower,
                                std::span<const double> concentration_upper,
                                std::span<const double> potential_lower,
                                std::span<const double> potential_upper, double spacing,
                                std::span<double> by_lower, std::span<double> by_upper,
                                std::span<double> by_difference) {
  exponentials(potential_lower, potential_upper);
  const double inverse_spacing = 1.0 / spacing;
  const std::size_t columns = exponential_.size();
#pragma omp simd
  for (std::size_t i = 0; i < columns; ++i) {
    const double u = potential_upper[i] - potential_lower[i];
    const double b = value_of(u, exponential_[i]);
    const double slope = derivative_of(u, b);
    by_lower[i] = inverse_spacing * b;
    by_upper[i] = inverse_spacing * (b + u);
    by_difference[i] =
        inverse_spacing * (slope * concentration_lower[i] - (slope + 1.0) * concentration_upper[i]);
  }
}

} // namespace ionskin::electrochemistry
