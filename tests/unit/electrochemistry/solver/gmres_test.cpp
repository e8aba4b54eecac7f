// SPDX-License-Identifier: Apache-2.0
#include "ionskin/electrochemistry/solver/gmres.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace ionskin::electrochemistry {
namespace {

constexpr std::size_t unknowns = 3000;

/// Unsymmetric three-point operator.
void convection_diffusion(std::span<const double> x, std::span<double> y) {
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double left = i > 0 ? x[i - 1] : 0.0, right = i + 1 < x.size() ? x[i + 1] : 0.0;
    y[i] = (2.5 + std::sin(static_cast<double>(i))) * x[i] - 1.2 * left - 0.3 * right;
  }
}

std::vector<double> right_hand_side() {
  std::vector<double> b(unknowns);
  for (std::size_t i = 0; i < unknowns; ++i) {
    b[i] = std::cos(0.01 * static_cast<double>(i));
  }
  return b;
}

double relative_residual(const std::vector<double>& x, const std::vector<double>& b) {
  std::vector<double> y(unknowns);
  convection_diffusion(x, y);
  double residual = 0.0, norm = 0.0;
  for (std::size_t i = 0; i < unknowns; ++i) {
    residual += (b[i] - y[i]) * (b[i] - y[i]);
    norm += b[i] * b[i];
  }
  return std::sqrt(residual / norm);
}

TEST(Gmres, ReachesItsToleranceThroughRestarts) {
  parallel::WorkerTeam team(1);
  Gmres gmres(unknowns, team);
  const auto b = right_hand_side();
  std::vector<double> x(unknowns, 7.0);
  const auto result = gmres.solve(convection_diffusion, b, x, 1e-10, 400);
  EXPECT_GT(result.iterations, 20);
  EXPECT_LE(result.relative_residual, 1e-10);
  EXPECT_NEAR(relative_residual(x, b), result.relative_residual, 1e-12);
}

TEST(Gmres, SolvesTheIdentityInOneIteration) {
  parallel::WorkerTeam team(1);
  Gmres gmres(unknowns, team);
  const auto b = right_hand_side();
  std::vector<double> x(unknowns);
  const auto identity = [](std::span<const double> from, std::span<double> to) {
    std::copy(from.begin(), from.end(), to.begin());
  };
  EXPECT_EQ(gmres.solve(identity, b, x, 1e-12, 10).iterations, 1);
  EXPECT_NEAR(x[100], b[100], 1e-14);
}

TEST(Gmres, ZeroRightHandSideNeedsNothing) {
  parallel::WorkerTeam team(1);
  Gmres gmres(10, team);
  std::vector<double> b(10, 0.0), x(10, 3.0);
  EXPECT_EQ(gmres.solve(convection_diffusion, b, x, 1e-6, 10).iterations, 0);
  EXPECT_EQ(x, b);
}

TEST(Gmres, IsTheSameOnAnyNumberOfThreads) {
  const auto b = right_hand_side();
  std::vector<std::vector<double>> solutions;
  for (const int threads : {1, 2, 3}) {
    parallel::WorkerTeam team(threads);
    Gmres gmres(unknowns, team);
    solutions.emplace_back(unknowns);
    gmres.solve(convection_diffusion, b, solutions.back(), 1e-8, 100);
  }
  EXPECT_EQ(solutions[0], solutions[1]);
  EXPECT_EQ(solutions[0], solutions[2]);
}

} // namespace
} // namespace ionskin::electrochemistry
