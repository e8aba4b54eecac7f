// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mesh/grading.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace ionskin::mesh {
namespace {

void expect_line(const std::vector<double>& line, double length) {
  EXPECT_EQ(line.front(), 0.0);
  EXPECT_EQ(line.back(), length);
  EXPECT_TRUE(std::is_sorted(line.begin(), line.end(), std::less_equal<>()));
}

TEST(Grading, GradedLineGrowsUpToTheLargestSize) {
  const auto line = graded_line(1.0, 0.02, 1.5, 0.2);
  expect_line(line, 1.0);
  EXPECT_LE(line[1], 0.02);
  EXPECT_NEAR((line[2] - line[1]) / line[1], 1.5, 1e-12);
  for (std::size_t i = 1; i < line.size(); ++i) {
    EXPECT_LE(line[i] - line[i - 1], 0.2 + 1e-12);
  }
}

TEST(Grading, GradedLineHoldsTheBoundOfItsZone) {
  const double width = 0.2, largest = 0.05;
  const auto line = graded_line(1.0, 0.01, 2, 0.4, {width, largest});
  expect_line(line, 1.0);
  double largest_behind = 0;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const double size = line[i] - line[i - 1];
    if (line[i - 1] < 0.7 * width) {
      EXPECT_LE(size, largest) << i;
    }
    largest_behind = std::max(largest_behind, size);
  }
  EXPECT_GT(largest_behind, 4 * largest);
  EXPECT_EQ(graded_line(1.0, 0.01, 2, 0.4, {width, 0.4}), graded_line(1.0, 0.01, 2, 0.4));
}

TEST(Grading, GeometricLineKeepsItsFirstSize) {
  for (const double length : {0.11, 0.8, 9.0}) {
    const auto line = geometric_line(length, 0.02, 8);
    expect_line(line, length);
    EXPECT_EQ(line.size(), 9u);
    EXPECT_NEAR(line[1], 0.02, 1e-13);
  }
}

TEST(Grading, GeometricRatioIsSmoothInTheLength) {
  // The second differences are small also where the ratio passes 1: second differences of a smooth
  // function fall with the step squared.
  const double middle = 16 * 0.01;
  const auto second_difference = [&](double step) {
    return geometric_ratio(middle + step, 0.01, 16) - 2 * geometric_ratio(middle, 0.01, 16) +
           geometric_ratio(middle - step, 0.01, 16);
  };
  EXPECT_NEAR(second_difference(2e-3) / second_difference(1e-3), 4.0, 0.05);
}

TEST(Grading, GrowingLineGrowsByTheRatio) {
  const auto line = growing_line(2.0, 1.5, 4);
  expect_line(line, 2.0);
  EXPECT_EQ(line.size(), 5u);
  for (std::size_t i = 2; i < line.size(); ++i) {
    EXPECT_NEAR((line[i] - line[i - 1]) / (line[i - 1] - line[i - 2]), 1.5, 1e-12);
  }
}

TEST(Grading, TwoSidedLineIsSymmetric) {
  const auto line = two_sided_line(2.0, 1.5, 5);
  expect_line(line, 2.0);
  const auto mirror = reversed(line);
  for (std::size_t i = 0; i < line.size(); ++i) {
    EXPECT_NEAR(line[i], mirror[i], 1e-15);
  }
  EXPECT_NEAR((line[2] - line[1]) / line[1], 1.5, 1e-12);
}

TEST(Grading, GeometricCountIsTheSmallestWithinTheGrowth) {
  const std::size_t count = geometric_count(9.0, 0.01, 1.6);
  EXPECT_LE(geometric_ratio(9.0, 0.01, count), 1.6);
  EXPECT_GT(geometric_ratio(9.0, 0.01, count - 1), 1.6);
}

} // namespace
} // namespace ionskin::mesh
