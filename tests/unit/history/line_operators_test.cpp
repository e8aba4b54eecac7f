// SPDX-License-Identifier: Apache-2.0
#include "ionskin/history/line_operators.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace ionskin::history {
namespace {

const std::vector<double> lines{0.0, 0.1, 0.15, 0.4, 1.0};

std::vector<double> gauss_points() {
  std::vector<double> points;
  for (std::size_t e = 0; e + 1 < lines.size(); ++e) {
    const double centre = 0.5 * (lines[e] + lines[e + 1]);
    const double half = 0.5 * (lines[e + 1] - lines[e]) / std::sqrt(3.0);
    points.push_back(centre - half);
    points.push_back(centre + half);
  }
  return points;
}

/// Weights that integrate each entry of an operator's result.
double total(const std::vector<double>& values, const std::vector<double>& weights) {
  return std::inner_product(values.begin(), values.end(), weights.begin(), 0.0);
}

std::vector<double> hat_volumes(const std::vector<double>& nodes) {
  std::vector<double> volumes(nodes.size(), 0.0);
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
    volumes[i] += 0.5 * (nodes[i + 1] - nodes[i]);
    volumes[i + 1] += 0.5 * (nodes[i + 1] - nodes[i]);
  }
  return volumes;
}

std::vector<double> applied(const LineOperator& line, const std::vector<double>& field) {
  std::vector<double> result;
  apply_along(line, 1, 1, field, result);
  return result;
}

TEST(LineOperators, ProjectionReproducesLinearFunctions) {
  const auto line = linear_projection(lines);
  std::vector<double> values;
  for (const double x : gauss_points()) {
    values.push_back(2 - 3 * x);
  }
  const auto nodes = applied(line, values);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    EXPECT_NEAR(nodes[i], 2 - 3 * lines[i], 1e-13);
  }
}

TEST(LineOperators, ProjectionConservesTheIntegralOfRoughValues) {
  const std::vector<double> rough{1, -2, 5, 0.3, 7, 7, -1, 4};
  double expected = 0;
  for (std::size_t q = 0; q < rough.size(); ++q) {
    expected += 0.5 * (lines[q / 2 + 1] - lines[q / 2]) * rough[q];
  }
  const auto nodes = applied(linear_projection(lines), rough);
  EXPECT_NEAR(total(nodes, hat_volumes(lines)), expected, 1e-13);
}

TEST(LineOperators, HalfMeansReproduceLinearFunctionsAndKeepTheIntegral) {
  const auto line = half_means_projection(lines);
  std::vector<double> values;
  for (std::size_t e = 0; e + 1 < lines.size(); ++e) {
    const double middle = 0.5 * (lines[e] + lines[e + 1]);
    values.push_back(2 - 3 * 0.5 * (lines[e] + middle));
    values.push_back(2 - 3 * 0.5 * (middle + lines[e + 1]));
  }
  const auto nodes = applied(line, values);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    EXPECT_NEAR(nodes[i], 2 - 3 * lines[i], 1e-13);
  }
  const std::vector<double> rough{1, -2, 5, 0.3, 7, 7, -1, 4};
  double expected = 0;
  for (std::size_t q = 0; q < rough.size(); ++q) {
    expected += 0.5 * (lines[q / 2 + 1] - lines[q / 2]) * rough[q];
  }
  EXPECT_NEAR(total(applied(line, rough), hat_volumes(lines)), expected, 1e-13);
}

TEST(LineOperators, CellAveragesConserveTheIntegralWithinTheLines) {
  const std::vector<double> nodes{3, 1, 4, 1, 5};
  const std::vector<double> cells{-0.3, 0.02, 0.12, 0.13, 0.7, 1.2, 1.5};
  const auto averages = applied(cell_averages(lines, cells), nodes);
  double integral = 0;
  for (std::size_t i = 0; i < averages.size(); ++i) {
    integral += averages[i] * std::max(0.0, std::min(cells[i + 1], 1.0) - std::max(cells[i], 0.0));
  }
  EXPECT_NEAR(integral, total(nodes, hat_volumes(lines)), 1e-13);
  EXPECT_DOUBLE_EQ(averages.back(), nodes.back());
}

TEST(LineOperators, OverlapAveragesConserveTheIntegral) {
  const std::vector<double> source{-1, 0, 0.3, 0.35, 2};
  const std::vector<double> target{0, 0.2, 0.32, 1.0};
  const std::vector<double> values{9, 2, -3, 4};
  const auto averages = applied(overlap_averages(source, target), values);
  double integral = 0;
  for (std::size_t i = 0; i < averages.size(); ++i) {
    integral += averages[i] * (target[i + 1] - target[i]);
  }
  EXPECT_NEAR(integral, 0.3 * 2 + 0.05 * -3 + 0.65 * 4, 1e-14);
}

TEST(LineOperators, HalfMeansAveragesKeepTheIntegralAndLinearFunctions) {
  const std::vector<double> source{0, 0.3, 0.35, 1.0}, target{0, 0.1, 0.2, 0.5, 0.9, 1.0};
  std::vector<double> linear; // 3 + 2 x
  for (const double middle : {0.075, 0.225, 0.3125, 0.3375, 0.5125, 0.8375}) {
    linear.push_back(3 + 2 * middle);
  }
  const auto averages = applied(half_means_averages(source, target), linear);
  for (std::size_t i = 0; i < averages.size(); ++i) {
    EXPECT_NEAR(averages[i], 3 + target[i] + target[i + 1], 1e-14) << i;
  }
  const std::vector<double> values{2, -1, 5, 4, 0, 7};
  const auto rough = applied(half_means_averages(source, target), values);
  double integral = 0;
  for (std::size_t i = 0; i < rough.size(); ++i) {
    integral += rough[i] * (target[i + 1] - target[i]);
  }
  EXPECT_NEAR(integral, 0.15 * (2 - 1) + 0.025 * (5 + 4) + 0.325 * (0 + 7), 1e-14);
}

TEST(LineOperators, HatAveragesConserveIntegralAndFirstMoment) {
  const std::vector<double> target{0, 0.01, 0.3, 0.55, 0.99, 1.0};
  const std::vector<double> values{1, 0, -2, 5, 3};
  const auto averages = applied(hat_averages(lines, target), values);
  const auto volumes = hat_volumes(target);
  double moment = 0;
  for (std::size_t i = 0; i < target.size(); ++i) {
    moment += volumes[i] * averages[i] * target[i];
  }
  double expected_moment = 0;
  for (std::size_t e = 0; e + 1 < lines.size(); ++e) {
    const double a = lines[e];
    const double b = lines[e + 1];
    expected_moment += (b - a) / 6 * (values[e] * (2 * a + b) + values[e + 1] * (a + 2 * b));
  }
  EXPECT_NEAR(total(averages, volumes), total(values, hat_volumes(lines)), 1e-14);
  EXPECT_NEAR(moment, expected_moment, 1e-14);
}

TEST(LineOperators, CompositionEqualsOneAfterTheOther) {
  const auto first = linear_projection(lines);
  const auto second = cell_averages(lines, {0, 0.2, 0.5, 1.0});
  const std::vector<double> values{1, 4, 2, 8, 5, 7, 1, 3};
  const auto both = applied(compose(second, first), values);
  const auto separate = applied(second, applied(first, values));
  for (std::size_t i = 0; i < both.size(); ++i) {
    EXPECT_NEAR(both[i], separate[i], 1e-14);
  }
}

TEST(LineOperators, AppliesAlongTheMiddleIndex) {
  const auto line = overlap_averages({0, 1, 2}, {0, 2});
  std::vector<double> result;
  apply_along(line, 2, 3, {1, 2, 3, 5, 6, 7, 10, 20, 30, 50, 60, 70}, result);
  EXPECT_EQ(result, (std::vector<double>{3, 4, 5, 30, 40, 50}));
}

} // namespace
} // namespace ionskin::history
