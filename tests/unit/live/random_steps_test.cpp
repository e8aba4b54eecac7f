// SPDX-License-Identifier: Apache-2.0
#include "ionskin/live/skin.hpp"
#include "small_skin.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace ionskin::live {
namespace {

/// Steps of random length to random places and loads, a skin each law of friction.
class RandomSteps : public testing::TestWithParam<std::pair<std::string, std::vector<double>>> {
protected:
  static SkinData data_under(const std::pair<std::string, std::vector<double>>& law) {
    SkinData data = sphere_on_many_cells(9);
    data.friction_law = law.first;
    data.friction_values = law.second;
    if (law.first == "regularised") {
      data.friction_parameters = {"slip_length"};
    } else if (law.first == "stribeck") {
      data.friction_parameters = {"kinetic_friction", "stribeck_speed", "lag_time"};
    }
    return data;
  }
  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(random_() >> 11u) * 0x1p-53;
  }
  void move() {
    const double step = std::pow(10, between(-4, 0)), way = data.fastest * step * between(0, 1);
    time += step;
    x = std::clamp(x + (between(0, 1) < 0.5 ? way : -way), data.lowest_place[0],
                   data.highest_place[0]);
  }
  std::uint32_t press(double force) { return skin.step(time, {x, 1e-3}, true, force, signals); }
  double of(const std::string& name) const {
    const auto at = std::ranges::find(skin.names(), name) - skin.names().begin();
    return signals[static_cast<std::size_t>(at)];
  }
  SkinData data = data_under(GetParam());
  Skin skin{data};
  std::vector<double> signals = std::vector<double>(skin.names().size());
  double time = 0, x = 3e-3;

private:
  std::mt19937_64 random_{1};
};

TEST_P(RandomSteps, MeetEveryForceWithoutAFlag) {
  for (int i = 0; i < 10000; ++i) {
    move();
    // Anything, little, or nothing at all.
    const double kind = between(0, 1), most = data.heaviest_force,
                 force = kind < 0.1   ? 0
                         : kind < 0.3 ? most * std::pow(10, between(-4, 0))
                                      : most * between(0, 1);
    ASSERT_EQ(press(force), 0u) << "step " << i << " to " << force << " N, residual "
                                << of("residual");
    ASSERT_NEAR(of("normal_force"), force, 1e-3 * force) << "step " << i;
    for (const double signal : signals) {
      ASSERT_TRUE(std::isfinite(signal)) << "step " << i;
    }
  }
}

TEST_P(RandomSteps, BeyondTheHeaviestForceThatOneIsTaken) {
  const double most = data.heaviest_force;
  for (int i = 0; i < 300; ++i) {
    move();
    press(most * between(0, 1));
    for (const double beyond : {1.01, 1.2, 2.0, 100.0}) {
      for (int repeat = 0; repeat < 3; ++repeat, time += 1e-3) {
        ASSERT_EQ(press(beyond * most), flag::outside_load) << "step " << i << " to " << beyond;
        ASSERT_NEAR(of("normal_force"), most, 1e-3 * most);
      }
    }
    ASSERT_EQ(press(-between(0, 1) * most), flag::pulled);
    ASSERT_EQ(of("normal_force"), 0);
    ASSERT_EQ(press(0), 0u);
  }
}

/// Skin with a stiff face: a cell gives as much under the force on a neighbour as under its own.
SkinData stiff_face() {
  constexpr std::size_t across = 21, cells = across * across;
  constexpr double width = 1e-4, softness = 1e-10;
  SkinData data = sphere_on_many_cells(across);
  data.heaviest_force = 400;
  data.stiffness = 1e7;
  std::ranges::fill(data.compliance.values, 0.0f);
  for (std::size_t i = 0; i < cells; ++i) {
    for (std::size_t j = 0; j < cells; ++j) {
      const auto apart = [&](std::size_t a, std::size_t b) {
        return width * (static_cast<double>(a) - static_cast<double>(b));
      };
      const double r = std::hypot(apart(i % across, j % across), apart(i / across, j / across));
      for (std::size_t c = 0; c < 3; ++c) {
        data.compliance.values[(3 * i + c) * 3 * cells + 3 * j + c] =
            static_cast<float>(softness / std::hypot(r, 2 * width));
      }
    }
  }
  return data;
}

TEST(StiffFace, LandsUnderAnyForceWithoutAFlag) {
  const SkinData data = stiff_face();
  Skin skin(data);
  std::vector<double> signals(skin.names().size());
  for (int i = 1; i <= 20; ++i) { // light contacts, whose cells multiply within a part of the step
    skin.reset();
    EXPECT_EQ(skin.step(0, {3e-3, 1e-3}, true, data.heaviest_force * i / 60, signals), 0u) << i;
  }
}

TEST(StiffFace, TakesAnyHeightWithoutAFlag) {
  SkinData data = stiff_face();
  data.heaviest_force = 1e9; // no height is too heavy
  data.deepest_indentation = 2e-5;
  Skin skin(data);
  std::vector<double> signals(skin.names().size());
  std::mt19937_64 random(1);
  for (int i = 0; i < 300; ++i) {
    const double share = static_cast<double>(random() >> 11u) * 0x1p-53;
    EXPECT_EQ(skin.step(1e-3 * i, {3e-3, 1e-3}, false, -share * data.deepest_indentation, signals),
              0u)
        << i;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Laws, RandomSteps,
    testing::Values(std::pair{std::string("coulomb"), std::vector<double>{}},
                    std::pair{std::string("regularised"), std::vector<double>{1e-7}},
                    std::pair{std::string("stribeck"), std::vector<double>{0.2, 1e-3, 5e-3}}),
    [](const auto& law) { return law.param.first; });

} // namespace
} // namespace ionskin::live
