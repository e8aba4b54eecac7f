// SPDX-License-Identifier: Apache-2.0
#include "ionskin/finite_layers/plane/half_space_cells.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace ionskin::finite_layers {
namespace {

/// Midpoint sums over two rectangles that do not touch.
InverseDistance midpoint_means(const Interval& x_at, const Interval& y_at, const Interval& x_from,
                               const Interval& y_from) {
  constexpr int count = 20;
  const auto place = [](const Interval& interval, int i) {
    return interval.from + (i + 0.5) / count * interval.size();
  };
  InverseDistance sum;
  for (int a = 0; a < count; ++a) {
    for (int b = 0; b < count; ++b) {
      for (int c = 0; c < count; ++c) {
        for (int d = 0; d < count; ++d) {
          const double u = place(x_at, a) - place(x_from, b), v = place(y_at, c) - place(y_from, d);
          const double r = std::hypot(u, v), weight = std::pow(count, -4);
          sum.inverse += weight / r;
          sum.cosine += weight * (u * u - v * v) / (r * r * r);
          sum.sine += weight * 2 * u * v / (r * r * r);
          sum.u += weight * u / (r * r);
          sum.v += weight * v / (r * r);
        }
      }
    }
  }
  return sum;
}

TEST(HalfSpaceCells, AgreeWithSumsOverBothRectangles) {
  const Interval x_at{-0.7, 0.4}, y_at{0.4, 1.1}, x_from{1.5, 2.0}, y_from{1.3, 2.2};
  const InverseDistance found = mean_inverse_distance(x_at, y_at, x_from, y_from),
                        expected = midpoint_means(x_at, y_at, x_from, y_from);
  EXPECT_NEAR(found.inverse, expected.inverse, 2e-4);
  EXPECT_NEAR(found.cosine, expected.cosine, 2e-4);
  EXPECT_NEAR(found.sine, expected.sine, 2e-4);
  EXPECT_NEAR(found.u, expected.u, 2e-4);
  EXPECT_NEAR(found.v, expected.v, 2e-4);
}

TEST(HalfSpaceCells, HaveTheKnownMeanOverASquare) {
  // Mean of 1/r between the points of a unit square: 4 asinh(1) + 4 (1 - sqrt 2)/3.
  const Interval unit{0, 1};
  const InverseDistance mean = mean_inverse_distance(unit, unit, unit, unit);
  EXPECT_NEAR(mean.inverse, 4 * std::asinh(1.0) + 4 * (1 - std::sqrt(2.0)) / 3, 1e-13);
  EXPECT_NEAR(mean.cosine, 0, 1e-13);
  EXPECT_NEAR(mean.sine, 0, 1e-13);
  EXPECT_NEAR(mean.u, 0, 1e-13);
}

TEST(HalfSpaceCells, OfACellAreTheSumOfItsParts) {
  const Interval x{0, 1}, y{0, 0.5}, left{0, 0.3}, right{0.3, 1}, x_at{0.5, 2}, y_at{0.2, 0.9};
  const InverseDistance whole = mean_inverse_distance(x_at, y_at, x, y),
                        first = mean_inverse_distance(x_at, y_at, left, y),
                        second = mean_inverse_distance(x_at, y_at, right, y);
  EXPECT_NEAR(whole.inverse, 0.3 * first.inverse + 0.7 * second.inverse, 1e-13);
  EXPECT_NEAR(whole.cosine, 0.3 * first.cosine + 0.7 * second.cosine, 1e-13);
  EXPECT_NEAR(whole.sine, 0.3 * first.sine + 0.7 * second.sine, 1e-13);
  EXPECT_NEAR(whole.u, 0.3 * first.u + 0.7 * second.u, 1e-13);
  EXPECT_NEAR(whole.v, 0.3 * first.v + 0.7 * second.v, 1e-13);
}

} // namespace
} // namespace ionskin::finite_layers
