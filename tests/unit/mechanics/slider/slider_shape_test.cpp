// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/slider/slider_shape.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace ionskin::mechanics {
namespace {

TEST(SliderShape, SphereAndCylinderRiseLikeCircles) {
  Slider slider;
  slider.shape = "sphere";
  slider.parameters["radius"] = 5e-3;
  slider.size = {10e-3, 10e-3};
  EXPECT_EQ(Underside(slider, {}).gap(0, 0), 0.0);
  EXPECT_NEAR(Underside(slider, {}).gap(3e-3, 0), 1e-3, 1e-17);
  EXPECT_NEAR(Underside(slider, {}).gap(0, 4e-3), 2e-3, 1e-17);
  EXPECT_EQ(Underside(slider, {}).gap(4e-3, 4e-3), shapes::unreachable_gap);
  slider.shape = "cylinder";
  EXPECT_NEAR(Underside(slider, {}).gap(3e-3, 4e-3), 1e-3, 1e-17);
  EXPECT_EQ(Underside(slider, {}).gap(0, 5.1e-3), shapes::unreachable_gap);
}

TEST(SliderShape, RoundedEdgesRunAroundTheCorners) {
  Slider slider;
  slider.size = {3e-3, 1.5e-3};
  EXPECT_EQ(Underside(slider, {}).gap(1.5e-3, 0.75e-3), 0.0);
  slider.parameters["edge_radius"] = 0.5e-3;
  const Underside underside(slider, {});
  EXPECT_EQ(underside.gap(1e-3, 0.25e-3), 0.0);
  EXPECT_NEAR(underside.gap(1.3e-3, 0), 0.1e-3, 1e-17);
  EXPECT_NEAR(underside.gap(-1e-3 - 0.18e-3, 0.25e-3 + 0.24e-3), 0.1e-3, 1e-17);
}

TEST(SliderShape, AProfileCountsFromItsLowestPointWithinThePlan) {
  Slider slider;
  slider.shape = "profile";
  slider.size = {2e-3, 2e-3};
  slider.profile_heights = {{-2e-3, 0, 2e-3}, {-1e-3, 1e-3}, {0, 3e-6, 6e-6, 0, 3e-6, 6e-6}};
  EXPECT_NEAR(Underside(slider, {}).gap(-1e-3, 0), 0, 1e-20);
  EXPECT_NEAR(Underside(slider, {}).gap(1e-3, 0.5e-3), 3e-6, 1e-20);
  const auto mean = mean_gap(slider, {-1e-3, 0, 1e-3}, {-1e-3, 1e-3}, {false, false});
  EXPECT_NEAR(mean[0], 0.75e-6, 1e-19);
  EXPECT_NEAR(mean[1], 2.25e-6, 1e-19);
  const auto reflected = mean_gap(slider, {-1e-3, 0, 1e-3}, {-1e-3, 1e-3}, {true, false});
  EXPECT_NEAR(reflected[0], mean[1], 1e-19);
}

TEST(SliderShape, MeansOverCellsAreExactForAParabola) {
  Slider slider;
  slider.shape = "cylinder";
  slider.parameters["radius"] = 1.0; // so large that circle and parabola agree
  slider.size = {2e-3, 2e-3};
  const auto mean = mean_gap(slider, {0, 1e-3}, {0, 1e-3}, {false, false});
  EXPECT_NEAR(mean[0], 1e-6 / 6, 1e-12);
}

} // namespace
} // namespace ionskin::mechanics
