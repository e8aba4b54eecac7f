// SPDX-License-Identifier: Apache-2.0
#include "ionskin/history/shear_statistics.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace ionskin::history {
namespace {

/// 2 x 1 columns over a 4 x 1 x 2 core; the first column is linear in z, the second constant.
CoreHistory two_columns() {
  CoreHistory history;
  history.grid = {{0, 1, 4}, {0, 1}, {0, 1, 2}};
  history.length = 4;
  history.width = 1;
  history.time = {0, 10};
  history.shear() = {std::make_shared<StrainField>(6, 0.0),
                     std::make_shared<StrainField>(StrainField{0, 3, 2, 3, 4, 3})};
  return history;
}

TEST(ShearStatistics, MatchesClosedForms) {
  const auto statistics = shear_statistics(two_columns(), 10);
  // Column 1: gamma = 2 z, mean 2; column 2: 3 over three quarters of the volume.
  EXPECT_NEAR(statistics.mean, (2 + 3 * 3) / 4.0, 1e-14);
  EXPECT_NEAR(statistics.rms, std::sqrt((16.0 / 3 + 3 * 9) / 4), 1e-14);
  // Mean over column 1 of 2 z (z/2 - 1/2) = 1/3; the constant column has none.
  EXPECT_NEAR(statistics.first_moment, 1.0 / 12, 1e-14);
  EXPECT_DOUBLE_EQ(statistics.element_max, 3);
  EXPECT_DOUBLE_EQ(statistics.p95, 3);
}

TEST(ShearStatistics, PercentileSplitsTheVolume) {
  CoreHistory history = two_columns();
  history.grid.x_edges = {0, 3.9, 4};
  history.shear()[1] = std::make_shared<StrainField>(StrainField{1, 5, 1, 5, 1, 5});
  const auto statistics = shear_statistics(history, 10);
  EXPECT_DOUBLE_EQ(statistics.p95, 1); // 97.5 % of the volume is at 1
  EXPECT_DOUBLE_EQ(statistics.p99, 5);
}

TEST(ShearStatistics, SizesOfASignedShearAreOfItsMagnitude) {
  CoreHistory history = two_columns();
  history.shear()[1] = std::make_shared<StrainField>(StrainField{0, -3, -2, -3, -4, -3});
  const auto statistics = shear_statistics(history, 10);
  const auto mirrored = shear_statistics(two_columns(), 10);
  EXPECT_DOUBLE_EQ(statistics.mean, -mirrored.mean);
  EXPECT_DOUBLE_EQ(statistics.first_moment, -mirrored.first_moment);
  EXPECT_DOUBLE_EQ(statistics.rms, mirrored.rms);
  EXPECT_DOUBLE_EQ(statistics.p95, mirrored.p95);
  EXPECT_DOUBLE_EQ(statistics.element_max, 3);
}

TEST(ShearStatistics, IntegratesTheMagnitudeThroughAChangeOfSign) {
  CoreHistory history = two_columns();
  EXPECT_DOUBLE_EQ(channel_integrals(history, history.channels.front(), 10).magnitude,
                   shear_integral(history, 10));
  // Column 1 from -1 over 1 to 1: two triangles of 1/4 and a square; column 2 is -3 throughout.
  history.shear()[1] = std::make_shared<StrainField>(StrainField{-1, -3, 1, -3, 1, -3});
  EXPECT_NEAR(channel_integrals(history, history.channels.front(), 10).magnitude, 1.5 + 3 * 2 * 3,
              1e-14);
  EXPECT_NEAR(shear_integral(history, 10), 1.0 - 3 * 2 * 3, 1e-14);
  EXPECT_DOUBLE_EQ(channel_integrals(history, history.channels.front(), 10).value,
                   shear_integral(history, 10));
}

TEST(ShearStatistics, IsLinearInTimeBetweenSamples) {
  const auto history = two_columns();
  EXPECT_NEAR(shear_statistics(history, 2.5).mean, 0.25 * shear_statistics(history, 10).mean,
              1e-15);
  EXPECT_NEAR(shear_integral(history, 2.5), 0.25 * shear_integral(history, 10), 1e-14);
  EXPECT_NEAR(shear_integral(history, 10), 8 * shear_statistics(history, 10).mean, 1e-13);
}

TEST(ShearStatistics, CountsOnlyWhatLiesInTheCore) {
  CoreHistory history = two_columns();
  history.frame = Frame::slider;
  history.grid.x_edges = {-4, 0, 4};
  history.grid.y_edges = {-0.5, 0.5};
  history.slider_x = {1, 1};
  history.shear()[1] = std::make_shared<StrainField>(StrainField{1, 2, 1, 2, 1, 2});
  EXPECT_NEAR(shear_integral(history, 10), 2 * (1 * 1 + 3 * 2), 1e-14);
}

} // namespace
} // namespace ionskin::history
