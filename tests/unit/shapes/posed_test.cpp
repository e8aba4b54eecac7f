// SPDX-License-Identifier: Apache-2.0
#include "ionskin/shapes/posed.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace ionskin::shapes {
namespace {

using std::numbers::pi;

const HeightMap no_heights;
const Plan oblong{{2e-3, 1e-3}, no_heights};

Posed posed(const char* name, const laws::LawValues& values, const Plan& plan, const Pose& pose,
            const ChangingAngles& changing = {}) {
  return {shape(name, values), plan, pose, changing};
}

TEST(Posed, QuarterTurnsExchangeSidesWithoutRounding) {
  for (const int turns : {1, 2, 3, -1, 5}) {
    const Pose pose{0, 0, turns * pi / 2};
    const bool odd = turns % 2 != 0;
    const auto size = posed_size(*shape("flat", {}), oblong, pose, {});
    EXPECT_EQ(size, odd ? (std::array{1e-3, 2e-3}) : oblong.size) << turns;
    const Posed block = posed("flat", {}, oblong, pose);
    EXPECT_TRUE(block.sharp()) << turns;
    EXPECT_EQ(block.flat_half_size(oblong), (std::array{size[0] / 2, size[1] / 2})) << turns;
    EXPECT_EQ(block.height(oblong, 0.49 * size[0], 0.49 * size[1]), 0.0) << turns;
    EXPECT_EQ(block.height(oblong, 0.51 * size[0], 0), unreachable_gap) << turns;
    EXPECT_EQ(block.symmetric(oblong), (std::array{true, true})) << turns;
  }
}

TEST(Posed, ATurnedBlockReachesToItsCorners) {
  const Pose pose{0, 0, pi / 6};
  const auto size = posed_size(*shape("flat", {}), oblong, pose, {});
  EXPECT_NEAR(size[0], 2e-3 * std::cos(pi / 6) + 1e-3 * 0.5, 1e-15);
  const Posed block = posed("flat", {}, oblong, pose);
  EXPECT_FALSE(block.sharp());
  EXPECT_EQ(block.symmetric(oblong), (std::array{false, false}));
  const double c = std::cos(pi / 6), s = 0.5, x = 0.99e-3, y = 0.49e-3; // near its own corner
  EXPECT_EQ(block.height(oblong, c * x - s * y, s * x + c * y), 0.0);
  EXPECT_EQ(block.height(oblong, c * x + s * y, s * x - c * y), 0.0); // and another one
  EXPECT_EQ(block.height(oblong, c * x - s * 1.1 * y, s * x + c * 1.1 * y), unreachable_gap);
  EXPECT_EQ(posed_size(*shape("flat", {}), oblong, {}, {.yaw = true})[0], std::hypot(2e-3, 1e-3));
}

TEST(Posed, PitchLowersTheFrontAndRollRaisesTheLeft) {
  const Posed block = posed("flat", {}, oblong, {0.01, 0.02, 0});
  EXPECT_NEAR(block.height(oblong, 0.5e-3, 0), -0.5e-3 * std::tan(0.02), 1e-18);
  EXPECT_NEAR(block.height(oblong, 0, 0.25e-3), 0.25e-3 * std::tan(0.01), 1e-18);
  EXPECT_NEAR(block.lowest(oblong), -1e-3 * std::tan(0.02) - 0.5e-3 * std::tan(0.01), 1e-18);
  EXPECT_TRUE(block.sharp()); // its edges lie where they did
  EXPECT_EQ(block.symmetric(oblong), (std::array{false, false}));
  EXPECT_EQ(posed("flat", {}, oblong, {0, 0.02, 0}).symmetric(oblong), (std::array{false, true}));
  EXPECT_EQ(posed("flat", {}, oblong, {0, 0, 0}, {.roll = true}).symmetric(oblong),
            (std::array{true, false}));
  // The tilt turns with the body: its front now points along y.
  const Posed turned = posed("flat", {}, oblong, {0, 0.02, pi / 2});
  EXPECT_NEAR(turned.height(oblong, 0, 0.5e-3), -0.5e-3 * std::tan(0.02), 1e-18);
}

TEST(Posed, ATiltedSphereTouchesBesideItsCentre) {
  const double radius = 4e-3, tilt = 0.05, slope = std::tan(tilt);
  const Plan plan{{2 * radius, 2 * radius}, no_heights};
  const Posed ball = posed("sphere", {{"radius", radius}}, plan, {0, tilt, 0});
  // Exactly: the least of R - sqrt(R^2 - x^2) - slope x.
  EXPECT_NEAR(ball.lowest(plan), radius * (1 - std::hypot(1, slope)), 1e-12);
  const double touches = radius * slope / std::hypot(1, slope);
  EXPECT_NEAR(ball.height(plan, touches, 0), ball.lowest(plan), 1e-12);
  EXPECT_GT(ball.border(plan, {.indentation = 1e-6, .plane_modulus = 1e9}, 0), touches);
  EXPECT_LT(ball.border(plan, {.indentation = 1e-6, .plane_modulus = 1e9}, 0), 2 * touches);
  // Upright it looks the same from all sides, but friction turns with it.
  const Posed upright = posed("sphere", {{"radius", radius}}, plan, {0, 0, 1}, {.yaw = true});
  EXPECT_EQ(upright.symmetric(plan), (std::array{false, false}));
  EXPECT_EQ(upright.border(plan, {.indentation = 1e-6, .plane_modulus = 1e9}, 0),
            shape("sphere", {{"radius", radius}})
                ->border(plan, {.indentation = 1e-6, .plane_modulus = 1e9}, 0));
  EXPECT_EQ(posed_size(*shape("sphere", {{"radius", radius}}), plan, {0, 0, 1}, {.yaw = true}),
            plan.size);
}

TEST(Posed, SidesAreAlongTheAxesAtQuarterTurnsOnly) {
  const Plan plan{{2e-3, 1e-3}, no_heights};
  EXPECT_TRUE(shape("flat", {})->along_axes());
  EXPECT_TRUE(posed("flat", {}, plan, {0.01, 0.02, pi / 2}).along_axes());
  EXPECT_FALSE(posed("flat", {}, plan, {0, 0, 0.3}).along_axes());
  EXPECT_FALSE(posed("flat", {}, plan, {}, {.yaw = true}).along_axes());
}

TEST(Posed, TheLowestOfATiltedMapIsExact) {
  const HeightMap map{{-1e-3, 0.3e-3, 1e-3}, {-1e-3, 1e-3}, {5e-6, 0, 5e-6, 5e-6, 1e-6, 5e-6}};
  const Plan plan{{2e-3, 2e-3}, map};
  const Posed body = posed("profile", {}, plan, {0, 1e-2, 0});
  EXPECT_NEAR(body.lowest(plan), 5e-6 - 1e-3 * std::tan(1e-2), 1e-18);
}

} // namespace
} // namespace ionskin::shapes
