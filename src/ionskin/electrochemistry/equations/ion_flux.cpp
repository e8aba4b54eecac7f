// SPDX-License-Identifier: Apache-2.0
#include "ionskin/electrochemistry/equations/ion_flux.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace ionskin::electrochemistry {
namespace {

/// Bound on |x| below which the Taylor series (remainder under 1e-17) replaces the formula, which
/// cancels there. Most of a core stays below it, where the series also is faster.
constexpr double series_limit = 0.5;

/// Coefficients of x^2, x^4, ... of B: Bernoulli numbers over factorials.
constexpr std::array<double, 7> even_coefficients{1.0 / 12.0,         -1.0 / 720.0,
                                                  1.0 / 30240.0,      -1.0 / 1209600.0,
                                                  1.0 / 47900160.0,   -691.0 / 1307674368000.0,
                                                  1.0 / 74724249600.0};

inline double value_series(double x) {
  const double x2 = x * x;
  double even = 0.0;
  for (std::size_t i = even_coefficients.size(); i-- > 0;) {
    even = even * x2 + even_coefficients[i];
  }
  return (1.0 - 0.5 * x) + x2 * even;
}

inline double derivative_series(double x) {
  const double x2 = x * x;
  double odd = 0.0;
  for (std::size_t i = even_coefficients.size(); i-- > 0;) {
    odd = odd * x2 + static_cast<double>(2 * (i + 1)) * even_coefficients[i];
  }
  return -0.5 + x * odd;
}

/// Bernoulli function B from x and exp(x).
inline double value_of(double x, double exponential) {
  const bool small = std::abs(x) < series_limit;
  const double formula = x / (small ? 1.0 : exponential - 1.0);
  return small ? value_series(x) : formula;
}

/// Derivative B' = B (1 - B - x) / x, which follows from exp(x) = 1 + x / B.
inline double derivative_of(double x, double value) {
  const bool small = std::abs(x) < series_limit;
  const double formula = value * (1.0 - value - x) / (small ? 1.0 : x);
  return small ? derivative_series(x) : formula;
}

/// Exponential of |x| <= 700 to 2e-16, as 2^n times the Taylor series of the rest. Unlike a library
/// function it is compiled into the loops below, so that the rounding of an element does not depend
/// on its position in a row.
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

/// Difference of potential beyond which no flux against the field is left in double precision.
constexpr double largest_difference = 700.0;

} // namespace

Bernoulli bernoulli(double x) {
  const double value =
      value_of(x, exponential(std::clamp(x, -largest_difference, largest_difference)));
  return {value, derivative_of(x, value)};
}

/// Calls `body(column, u, B(u))` for all columns.
template <class Body>
void ThicknessFlux::for_columns(std::span<const double> potential_lower,
                                std::span<const double> potential_upper, const Body& body) {
  double* difference = difference_.data();
  const std::size_t columns = difference_.size();
  double largest = 0.0;
#pragma omp simd reduction(max : largest)
  for (std::size_t i = 0; i < columns; ++i) {
    difference[i] = potential_upper[i] - potential_lower[i];
    largest = std::max(largest, std::abs(difference[i]));
  }
  if (largest < series_limit) {
#pragma omp simd
    for (std::size_t i = 0; i < columns; ++i) {
      body(i, difference[i], value_series(difference[i]));
    }
    return;
  }
  double* power = exponential_.data();
#pragma omp simd
  for (std::size_t i = 0; i < columns; ++i) {
    power[i] =
        exponential(std::min(std::max(difference[i], -largest_difference), largest_difference));
  }
#pragma omp simd
  for (std::size_t i = 0; i < columns; ++i) {
    body(i, difference[i], value_of(difference[i], power[i]));
  }
}

void ThicknessFlux::evaluate(std::span<const double> concentration_lower,
                             std::span<const double> concentration_upper,
                             std::span<const double> potential_lower,
                             std::span<const double> potential_upper, double spacing,
                             std::span<double> flux) {
  const double inverse_spacing = 1.0 / spacing;
  for_columns(potential_lower, potential_upper, [&](std::size_t i, double u, double b) {
    flux[i] = inverse_spacing * (b * concentration_lower[i] - (b + u) * concentration_upper[i]);
  });
}

void ThicknessFlux::derivatives(std::span<const double> concentration_lower,
                                std::span<const double> concentration_upper,
                                std::span<const double> potential_lower,
                                std::span<const double> potential_upper, double spacing,
                                std::span<double> by_lower, std::span<double> by_upper,
                                std::span<double> by_difference) {
  const double inverse_spacing = 1.0 / spacing;
  for_columns(potential_lower, potential_upper, [&](std::size_t i, double u, double b) {
    const double slope = derivative_of(u, b);
    by_lower[i] = inverse_spacing * b;
    by_upper[i] = inverse_spacing * (b + u);
    by_difference[i] =
        inverse_spacing * (slope * concentration_lower[i] - (slope + 1.0) * concentration_upper[i]);
  });
}

} // namespace ionskin::electrochemistry
