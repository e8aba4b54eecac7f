// SPDX-License-Identifier: Apache-2.0
#include "allocation_counter.hpp"
#include "ionskin/live/interface/ionskin_live.hpp"
#include "ionskin/live/skin.hpp"
#include "small_skin.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

namespace ionskin::live {
namespace {

using Wrench = std::array<double, 6>;

/// Inputs of a step.
struct Given {
  double time = 0;
  std::array<double, 2> place{};
  double depth = 0;
};

Wrench wrench_of(Skin& skin, const Given& given) {
  std::vector<double> signals(skin.names().size());
  EXPECT_EQ(skin.step(given.time, given.place, false, -given.depth, signals), 0u);
  const std::size_t moment = signals.size() - 3;
  return {signals[5],      signals[6],          -signals[3],
          signals[moment], signals[moment + 1], signals[moment + 2]};
}

/// Differences over a step from a state, by ways along x, y, z and turns about x and y.
void expect_stiffness(const SkinData& data, const std::vector<Given>& before, const Given& given,
                      double way, double tolerance) {
  Skin skin(data);
  for (const Given& step : before) {
    wrench_of(skin, step);
  }
  const std::vector<double> state(skin.state().begin(), skin.state().end());
  wrench_of(skin, given);
  std::array<double, 36> stiffness{};
  const std::size_t taken = allocations();
  ASSERT_TRUE(skin.stiffness(stiffness));
  EXPECT_EQ(allocations(), taken);
  const double arm = std::max(data.cell_lines_x.back(), data.cell_lines_y.back());
  double largest = 0; // of a force by a way
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t motion = 0; motion < 3; ++motion) {
      largest = std::max(largest, std::abs(stiffness[6 * row + motion]));
    }
  }
  EXPECT_GT(largest, 0);
  for (std::size_t motion = 0; motion < 5; ++motion) {
    const double step = motion < 3 ? way : way / arm;
    std::array<Wrench, 2> at{};
    for (const std::size_t end : {0u, 1u}) {
      const double change = (end == 0 ? -0.5 : 0.5) * step;
      Given there = given;
      if (motion < 2) {
        there.place[motion] += change;
      } else if (motion == 2) {
        there.depth -= change;
      }
      const SkinData own = motion > 2 ? turned(data, motion - 3, change) : data;
      Skin other(own);
      ASSERT_TRUE(other.restore(state));
      at[end] = wrench_of(other, there);
    }
    for (std::size_t row = 0; row < 6; ++row) {
      const double scale = largest * (row < 3 ? 1 : arm) * (motion < 3 ? 1 : arm);
      EXPECT_NEAR(stiffness[6 * row + motion], (at[1][row] - at[0][row]) / step, tolerance * scale)
          << "row " << row << " by motion " << motion;
    }
  }
}

constexpr std::array<double, 2> landing_place{3e-3, 1e-3};
constexpr double pressed_depth = 8e-6;

TEST(LiveStiffness, IsTheDifferenceOfStepsWhereAllSticks) {
  SkinData data = sphere_under("coulomb");
  data.friction = data.highest_friction = 2;
  const Given landed{0, landing_place, pressed_depth},
      next{1e-3, {3e-3 + 2e-8, 1e-3 + 1e-8}, pressed_depth + 1e-8};
  expect_stiffness(data, {landed}, next, 4e-9, 5e-3);
}

TEST(LiveStiffness, IsTheDifferenceOfStepsUnderEveryFriction) {
  for (const char* law : {"coulomb", "regularised", "viscous", "stribeck", "anisotropic"}) {
    SCOPED_TRACE(law);
    const SkinData data = sphere_under(law);
    // All of it slides; then a part of the contact of a longer way does.
    const Given landed{0, landing_place, pressed_depth},
        sliding{1e-2, {3e-3 + 2e-4, 1e-3 + 1e-4}, pressed_depth},
        on{1.1e-2, {3e-3 + 2.1e-4, 1e-3 + 1.08e-4}, pressed_depth},
        back{1.2e-2, {3e-3 + 2.1e-4 - 6e-7, 1e-3 + 1.08e-4}, pressed_depth};
    expect_stiffness(data, {landed, sliding}, on, 1e-8, 5e-3);
    expect_stiffness(data, {landed, sliding, on}, back, 1e-9, 2e-2);
  }
}

// Each cell stands at its friction limit in such a rest. It sticks if the slider turns back.
TEST(LiveStiffness, AtRestAfterASlideIsThatOfTheWayBack) {
  for (const char* law : {"coulomb", "anisotropic"}) {
    SCOPED_TRACE(law);
    const SkinData data = sphere_under(law);
    const std::array<double, 2> end{3e-3 + 2e-4, 1e-3};
    for (const int rests : {1, 2, 7}) {
      Skin skin(data);
      wrench_of(skin, {0, landing_place, pressed_depth});
      wrench_of(skin, {1e-2, end, pressed_depth});
      double time = 1e-2;
      for (int rest = 1; rest < rests; ++rest) {
        wrench_of(skin, {time += 1e-3, end, pressed_depth});
      }
      const std::vector<double> state(skin.state().begin(), skin.state().end());
      const Wrench here = wrench_of(skin, {time += 1e-3, end, pressed_depth});
      std::array<double, 36> stiffness{};
      ASSERT_TRUE(skin.stiffness(stiffness));
      const double way = 1e-9;
      ASSERT_TRUE(skin.restore(state));
      const Wrench back = wrench_of(skin, {time, {end[0] - way, end[1]}, pressed_depth});
      EXPECT_GT(stiffness[0], 0);
      EXPECT_NEAR((here[0] - back[0]) / way, stiffness[0], 0.02 * stiffness[0]) << rests;
      EXPECT_NEAR((here[2] - back[2]) / way, stiffness[12], 0.02 * stiffness[0]) << rests;
    }
  }
}

TEST(LiveStiffness, IsNoneInTheAirAndUnknownWithoutAStep) {
  const SkinData data = sphere_under("coulomb");
  Skin skin(data);
  std::array<double, 36> stiffness{};
  EXPECT_FALSE(skin.stiffness(stiffness));
  EXPECT_TRUE(std::isnan(stiffness[0]));
  wrench_of(skin, {0, landing_place, -1e-6});
  ASSERT_TRUE(skin.stiffness(stiffness));
  EXPECT_EQ(*std::ranges::max_element(stiffness), 0);
  wrench_of(skin, {1e-3, landing_place, pressed_depth});
  ASSERT_TRUE(skin.stiffness(stiffness));
  EXPECT_GT(stiffness[6 * 2 + 2], 0); // pressed less, it pushes less
  ASSERT_TRUE(skin.restore(std::vector<double>(skin.state().begin(), skin.state().end())));
  EXPECT_FALSE(skin.stiffness(stiffness));
}

TEST(LiveStiffness, OfAHalfSkinIsThatOfItsSymmetricMotions) {
  SkinData data = sphere_under("coulomb"), half = data;
  half.meshed_share = 0.5;
  std::array<double, 36> whole{}, of_half{};
  Skin skin(data), other(half);
  for (Skin* one : {&skin, &other}) {
    wrench_of(*one, {0, landing_place, pressed_depth});
    ASSERT_TRUE(one->stiffness(one == &skin ? whole : of_half));
  }
  EXPECT_DOUBLE_EQ(of_half[6 * 2 + 2], 2 * whole[6 * 2 + 2]);
  EXPECT_TRUE(std::isnan(of_half[6 * 2 + 1]));
  EXPECT_EQ(of_half[6 * 1 + 2], 0);
}

TEST(LiveStiffness, IsReportedByCAndCxx) {
  const SkinData data = sphere_under("coulomb");
  const auto path = std::filesystem::temp_directory_path() / "ionskin_live_stiffness.live";
  write_skin(path, data);
  ionskin_live::Skin skin(path.string());
  std::filesystem::remove(path);
  std::array<double, 36> expected{}, by_c{};
  Skin own(data);
  wrench_of(own, {0, landing_place, pressed_depth});
  ASSERT_TRUE(own.stiffness(expected));
  EXPECT_FALSE(skin.stiffness(by_c));
  skin.step(0, landing_place, ionskin_live::Height{-pressed_depth});
  EXPECT_TRUE(skin.stiffness(by_c));
  EXPECT_EQ(by_c, expected);
}

} // namespace
} // namespace ionskin::live
