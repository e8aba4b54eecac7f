// SPDX-License-Identifier: Apache-2.0
#include "ionskin/parallel/vector_operations.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace ionskin::parallel {
namespace {

std::vector<double> wave(std::size_t length, double frequency) {
  std::vector<double> values(length);
  for (std::size_t i = 0; i < length; ++i) {
    values[i] = std::sin(frequency * static_cast<double>(i) + 0.3);
  }
  return values;
}

TEST(VectorOperations, SumsAreTheSameOnAnyNumberOfThreads) {
  const auto a = wave(5000, 0.37), b = wave(5000, 0.11);
  double plain = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    plain += a[i] * b[i];
  }
  WorkerTeam one(1), three(3);
  const double dot = VectorOperations(one).dot(a, b);
  EXPECT_NEAR(dot, plain, 1e-10);
  EXPECT_EQ(dot, VectorOperations(three).dot(a, b));
  EXPECT_EQ(VectorOperations(one).norm(a), VectorOperations(three).norm(a));
}

TEST(VectorOperations, LargestMagnitudeOfNaNIsNaN) {
  auto a = wave(3000, 0.2);
  a[700] = std::numeric_limits<double>::quiet_NaN();
  WorkerTeam team(2);
  EXPECT_TRUE(std::isnan(VectorOperations(team).largest_magnitude(a)));
}

TEST(VectorOperations, LargestMagnitudeSeesNegativeValues) {
  auto a = wave(3000, 0.2);
  a[1500] = -7.0;
  WorkerTeam team(2);
  EXPECT_EQ(VectorOperations(team).largest_magnitude(a), 7.0);
}

TEST(VectorOperations, OrthogonaliseLeavesThePartOutsideTheBasis) {
  constexpr std::size_t length = 4000;
  std::vector<std::vector<double>> basis(2, std::vector<double>(length, 0.0));
  basis[0][10] = 1.0;
  basis[1][3000] = 1.0;
  std::vector<double> vector(length, 0.0);
  vector[10] = 2.0;
  vector[3000] = -3.0;
  vector[3500] = 4.0;
  std::array<double, 2> coefficients{};
  WorkerTeam team(2);
  EXPECT_DOUBLE_EQ(VectorOperations(team).orthogonalise(basis, 2, vector, coefficients), 4.0);
  EXPECT_EQ(coefficients, (std::array<double, 2>{2.0, -3.0}));
  EXPECT_EQ(vector[10], 0.0);
  EXPECT_EQ(vector[3500], 4.0);
}

TEST(VectorOperations, Updates) {
  WorkerTeam team(2);
  const VectorOperations vectors(team);
  const std::vector<double> x{1.0, 2.0}, d{10.0, 20.0};
  std::vector<double> y{0.5, 0.5};
  vectors.add(2.0, x, y);
  EXPECT_EQ(y, (std::vector<double>{2.5, 4.5}));
  vectors.combine(x, -1.0, d, y);
  EXPECT_EQ(y, (std::vector<double>{-9.0, -18.0}));
  vectors.scale(0.5, d, y);
  EXPECT_EQ(y, (std::vector<double>{5.0, 10.0}));
}

} // namespace
} // namespace ionskin::parallel
