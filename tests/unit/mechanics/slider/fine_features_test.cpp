// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/slider/fine_features.hpp"

#include "ionskin/mechanics/slider/slider_shape.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

namespace ionskin::mechanics {
namespace {

constexpr double reached_depth = 5e-6; // [m]

/// A slider of 2 mm whose underside is a map on a grid of 10 um.
Slider mapped(const std::function<double(double, double)>& height) {
  Slider slider;
  slider.shape = "profile";
  slider.size = {2e-3, 2e-3};
  for (int i = -100; i <= 100; ++i) {
    slider.profile_heights.x.push_back(1e-5 * i);
  }
  slider.profile_heights.y = slider.profile_heights.x;
  for (const double y : slider.profile_heights.y) {
    for (const double x : slider.profile_heights.x) {
      slider.profile_heights.height.push_back(height(x, y));
    }
  }
  return slider;
}

std::vector<double> lines_of(int cells) {
  std::vector<double> lines;
  for (int i = 0; i <= cells; ++i) {
    lines.push_back(-1e-3 + 2e-3 * i / cells);
  }
  return lines;
}

double ripple(double x, double /*y*/) {
  return 1e-6 * std::sin(2 * std::numbers::pi * x / 2e-4); // ten periods
}

TEST(FineFeatures, AreWhatCellsAverageAway) {
  const Slider slider = mapped(ripple);
  // A cell holds two periods: amplitude over root two, less the little of a sine that is a slope.
  const FineFeatures coarse = fine_features(slider, lines_of(5), lines_of(5), reached_depth);
  EXPECT_NEAR(coarse.departure, 1e-6 / std::numbers::sqrt2, 0.15e-6);
  EXPECT_NEAR(coarse.cell_size[0], 4e-4, 1e-12);
  // An eighth of a period is a plane to some percent.
  EXPECT_LT(fine_features(slider, lines_of(80), lines_of(5), reached_depth).departure, 0.06e-6);
}

TEST(FineFeatures, OfARoundOrTiltedMapAreNone) {
  const Slider ball = mapped([](double x, double y) { return (x * x + y * y) / (2 * 20e-3); });
  EXPECT_FALSE(warn_of_fine_features(ball, lines_of(10), lines_of(10), reached_depth));
  const Slider tilted = mapped([](double x, double y) { return 0.01 * x + 0.02 * y; });
  EXPECT_LT(fine_features(tilted, lines_of(5), lines_of(5), 1).departure, 1e-12);
}

TEST(FineFeatures, AreWarnedOfWithTheRemedyWhereTheyCount) {
  const Slider slider = mapped(ripple);
  const auto warning = warn_of_fine_features(slider, lines_of(5), lines_of(5), reached_depth);
  ASSERT_TRUE(warning);
  for (const char* part :
       {"400 um x 400 um", "of the deepest indentation", "numerics.mesh_refinement"}) {
    EXPECT_NE(warning->find(part), std::string::npos) << *warning;
  }
  EXPECT_FALSE(warn_of_fine_features(slider, lines_of(80), lines_of(80), reached_depth));
  EXPECT_FALSE(
      warn_of_fine_features(slider, lines_of(5), lines_of(5), 20 * reached_depth)); // shallow
  // Cells that the underside does not reach are left out.
  const Slider far =
      mapped([](double x, double y) { return ripple(x, y) + (x > 0.3e-3 ? 0 : 1e-3); });
  const std::vector<double> left{-1e-3, -0.6e-3, -0.2e-3};
  EXPECT_EQ(fine_features(far, left, left, reached_depth).departure, 0);
}

} // namespace
} // namespace ionskin::mechanics
