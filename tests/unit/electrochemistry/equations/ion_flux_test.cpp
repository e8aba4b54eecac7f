// SPDX-License-Identifier: Apache-2.0
#include "ionskin/electrochemistry/equations/ion_flux.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace ionskin::electrochemistry {
namespace {

TEST(Bernoulli, ValueAndDerivativeAgreeWithTheFormulaAndItsSymmetry) {
  for (const double x : {-700.0, -40.0, -3.0, -0.5001, -0.4999, -0.1, -1e-3, 0.0, 1e-9, 0.05,
                         0.4999, 0.5001, 2.0, 30.0, 600.0}) {
    const Bernoulli b = bernoulli(x);
    const double expected = x == 0.0 ? 1.0 : x / std::expm1(x);
    EXPECT_NEAR(b.value, expected, 2e-15 * std::max(1.0, std::abs(x))) << x;
    EXPECT_NEAR(bernoulli(-x).value, b.value + x, 4e-15 * std::max(1.0, std::abs(x))) << x;
    const double step = 1e-5;
    EXPECT_NEAR(b.derivative,
                (bernoulli(x + step).value - bernoulli(x - step).value) / (2.0 * step),
                1e-9 * std::max(1.0, std::abs(x)))
        << x;
  }
}

using Row = std::array<double, 4>;
constexpr Row c_lower{1.0, 0.3, 2.0, 0.7}, c_upper{0.4, 1.7, 0.2, 0.7};
constexpr Row phi_lower{0.0, 1.0, -2.0, 0.01}, phi_upper{0.02, -3.0, 5.0, 0.0};
constexpr double spacing = 0.3;

Row flux(const Row& a, const Row& b, const Row& p, const Row& q) {
  ThicknessFlux thickness_flux(4);
  Row result{};
  thickness_flux.evaluate(a, b, p, q, spacing, result);
  return result;
}

TEST(ThicknessFlux, VanishesInBoltzmannEquilibrium) {
  Row upper{};
  for (std::size_t i = 0; i < upper.size(); ++i) {
    upper[i] = c_lower[i] * std::exp(phi_lower[i] - phi_upper[i]);
  }
  for (const double value : flux(c_lower, upper, phi_lower, phi_upper)) {
    EXPECT_NEAR(value, 0.0, 1e-14);
  }
}

TEST(ThicknessFlux, IsDiffusionWithoutField) {
  const Row result = flux(c_lower, c_upper, phi_lower, phi_lower);
  for (std::size_t i = 0; i < result.size(); ++i) {
    EXPECT_NEAR(result[i], (c_lower[i] - c_upper[i]) / spacing, 1e-14);
  }
}

TEST(ThicknessFlux, OfWeakFieldsIsTheSameBesideStrongOnes) {
  Row weak{}, with_strong{};
  for (std::size_t i = 0; i < weak.size(); ++i) {
    weak[i] = with_strong[i] = phi_lower[i] + 0.1 * (static_cast<double>(i) - 1.5);
  }
  with_strong[3] += 2.0;
  const Row alone = flux(c_lower, c_upper, phi_lower, weak);
  const Row beside = flux(c_lower, c_upper, phi_lower, with_strong);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(alone[i], beside[i], 1e-15);
  }
}

TEST(ThicknessFlux, DerivativesAgreeWithDifferences) {
  Row by_lower{}, by_upper{}, by_difference{};
  ThicknessFlux(4).derivatives(c_lower, c_upper, phi_lower, phi_upper, spacing, by_lower, by_upper,
                               by_difference);
  const double step = 1e-6;
  const auto shifted = [](Row row, double shift) {
    for (double& value : row) {
      value += shift;
    }
    return row;
  };
  for (std::size_t i = 0; i < 4; ++i) {
    const double lower = (flux(shifted(c_lower, step), c_upper, phi_lower, phi_upper)[i] -
                          flux(shifted(c_lower, -step), c_upper, phi_lower, phi_upper)[i]) /
                         (2.0 * step);
    const double upper = (flux(c_lower, shifted(c_upper, step), phi_lower, phi_upper)[i] -
                          flux(c_lower, shifted(c_upper, -step), phi_lower, phi_upper)[i]) /
                         (2.0 * step);
    const double difference = (flux(c_lower, c_upper, phi_lower, shifted(phi_upper, step))[i] -
                               flux(c_lower, c_upper, phi_lower, shifted(phi_upper, -step))[i]) /
                              (2.0 * step);
    EXPECT_NEAR(by_lower[i], lower, 1e-8);
    EXPECT_NEAR(-by_upper[i], upper, 1e-8);
    EXPECT_NEAR(by_difference[i], difference, 1e-8);
  }
}

} // namespace
} // namespace ionskin::electrochemistry
