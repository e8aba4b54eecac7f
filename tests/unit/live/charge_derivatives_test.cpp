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

/// Values between -1 and 1 that no symmetry relates.
std::vector<float> any_values(std::size_t count, double phase, double scale) {
  std::vector<float> result(count);
  for (std::size_t i = 0; i < count; ++i) {
    result[i] = static_cast<float>(scale * std::sin(phase + 1.7 * static_cast<double>(i * i % 97)));
  }
  return result;
}

/// A skin in which everything between forces and charges counts: strains and modes that change with
/// the place, modes that stay with the skin, states that follow, charge that spreads.
SkinData charged_sphere(const std::string& law) {
  constexpr std::size_t points = 3, per = 2, levels = 2, modes = 3;
  SkinData data = sphere_under(law);
  data.turns_into_itself = 1;
  data.fastest_turn = 1;
  data.deepest_indentation = 2e-4; // a step to its depths is one part
  const std::size_t size = 3 * data.area.size();
  ChannelMap& channel = data.channels.front();
  channel.rows_per_point = per;
  const auto over_places = [](std::vector<float> mean, const std::vector<float>& change) {
    mean.insert(mean.end(), change.begin(), change.end());
    return PlaceMap{{1e-3, 3e-3, 5e-3}, {4e-4, 1.6e-3}, {-1, 0.5, 1, -0.7, 0.6, 0.8}, mean};
  };
  channel.strain = over_places(any_values(size * points * per, 0.3, 1e-3),
                               any_values(size * points * per, 0.9, 3e-4));
  channel.fit =
      over_places(any_values(modes * points, 1.1, 1), any_values(modes * points, 2.1, 0.4));
  channel.x_edges = {-2e-3, -7e-4, 1e-4, 9e-4, 2.2e-3};
  channel.y_edges = {-1.5e-3, -2e-4, 5e-4, 1.4e-3};
  channel.field = any_values(2 * levels * 12, 0.2, 1);
  channel.fixed_x_edges = {0, 2.5e-3, data.length};
  channel.fixed_y_edges = {0, 8e-4, data.width};
  channel.fixed_field = any_values(levels * 4, 0.7, 1);
  data.part = {2 * levels,
               {2, 1, 0.4, 0.3, 1, 2, -0.2, 0.5},
               {-1, 0, 0.3, 0.1, 0, -0.5, 0.2, 0, 0, -1, 0.1, 0.4, -0.5, 0, 0, 0.2}};
  return data;
}

/// Inputs of a step.
struct StepInputs {
  double time = 0;
  std::array<double, 2> place{};
  double depth = 0, yaw = 0;
};

std::vector<double> charges_of(Skin& skin, const StepInputs& given) {
  std::vector<double> signals(skin.names().size()), charges;
  EXPECT_EQ(skin.step(given.time, given.place, {0, 0, given.yaw}, false, -given.depth, signals),
            0u);
  for (std::size_t i = 0; i < signals.size(); ++i) {
    if (skin.names()[i].starts_with("charge_")) {
      charges.push_back(signals[i]);
    }
  }
  EXPECT_EQ(charges.size(), skin.charges());
  return charges;
}

/// Differences over a step from a state by each motion; of a first step, which drags nothing, by
/// those that press.
void expect_derivatives(const SkinData& data, const std::vector<StepInputs>& before,
                        const StepInputs& given, double way, double tolerance) {
  Skin skin(data);
  for (const StepInputs& step : before) {
    charges_of(skin, step);
  }
  const std::vector<double> state(skin.state().begin(), skin.state().end());
  charges_of(skin, given);
  std::vector<double> derivatives(motions * skin.charges());
  const std::size_t taken = allocations();
  ASSERT_TRUE(skin.charge_derivatives(derivatives));
  EXPECT_EQ(allocations(), taken);
  const double arm = std::max(data.cell_lines_x.back(), data.cell_lines_y.back());
  for (std::size_t motion = 0; motion < motions; ++motion) {
    if (before.empty() && (motion < 2 || motion == 5)) {
      continue;
    }
    // A turn moves little charge beside what single precision rounds.
    const double step = motion < 3 ? way : motion < 5 ? way / arm : 10 * way / arm;
    std::array<std::vector<double>, 2> at;
    for (const std::size_t end : {0u, 1u}) {
      const double change = (end == 0 ? -0.5 : 0.5) * step;
      StepInputs there = given;
      there.place[0] += motion == 0 ? change : 0;
      there.place[1] += motion == 1 ? change : 0;
      there.depth -= motion == 2 ? change : 0;
      there.yaw += motion == 5 ? change : 0;
      const SkinData own = motion == 3 || motion == 4 ? turned(data, motion - 3, change) : data;
      Skin other(own);
      ASSERT_TRUE(other.restore(state));
      at[end] = charges_of(other, there);
    }
    double largest = 0;
    for (std::size_t charge = 0; charge < skin.charges(); ++charge) {
      largest = std::max(largest, std::abs(derivatives[motions * charge + motion]));
    }
    EXPECT_GT(largest, 0) << motion;
    for (std::size_t charge = 0; charge < skin.charges(); ++charge) {
      EXPECT_NEAR(derivatives[motions * charge + motion], (at[1][charge] - at[0][charge]) / step,
                  tolerance * largest)
          << "charge " << charge << " by motion " << motion;
    }
  }
}

constexpr std::array<double, 2> charged_place{3.1e-3, 1.03e-3};
constexpr double charged_depth = 8e-6;

TEST(LiveChargeDerivatives, AreDifferencesOfStepsWhereAllSticks) {
  SkinData data = charged_sphere("coulomb");
  data.friction = data.highest_friction = 2;
  const StepInputs landed{0, charged_place, charged_depth},
      next{1e-3, {charged_place[0] + 2e-8, charged_place[1] + 1e-8}, charged_depth + 1e-8};
  expect_derivatives(data, {landed}, next, 4e-9, 1e-2);
  expect_derivatives(data, {}, landed, 4e-9, 1e-2);
}

TEST(LiveChargeDerivatives, AreDifferencesOfStepsUnderEveryFriction) {
  for (const char* law : {"coulomb", "regularised", "viscous", "stribeck", "anisotropic"}) {
    SCOPED_TRACE(law);
    const auto [x, y] = charged_place;
    const StepInputs landed{0, charged_place, charged_depth},
        sliding{1e-2, {x + 2e-4, y + 1e-4}, charged_depth},
        on{1.1e-2, {x + 2.1e-4, y + 1.08e-4}, charged_depth, 1e-4};
    expect_derivatives(charged_sphere(law), {landed, sliding}, on, 1e-8, 1e-2);
  }
}

TEST(LiveChargeDerivatives, AreNoneInTheAirAndUnknownWithoutAStep) {
  const SkinData data = charged_sphere("coulomb");
  Skin skin(data);
  std::vector<double> derivatives(motions * skin.charges());
  EXPECT_FALSE(skin.charge_derivatives(derivatives));
  EXPECT_TRUE(std::isnan(derivatives[0]));
  charges_of(skin, {0, charged_place, charged_depth});
  charges_of(skin, {1e-3, charged_place, -1e-6});
  ASSERT_TRUE(skin.charge_derivatives(derivatives));
  EXPECT_EQ(std::ranges::count(derivatives, 0.0), static_cast<std::ptrdiff_t>(derivatives.size()));
}

TEST(LiveChargeDerivatives, LeaveTheStepsThatFollowAsTheyAre) {
  const SkinData data = charged_sphere("coulomb");
  Skin skin(data), asked(data);
  std::vector<double> derivatives(motions * skin.charges());
  for (int i = 0; i < 20; ++i) {
    const StepInputs given{
        1e-3 * i, {charged_place[0] + 1e-6 * i, charged_place[1]}, charged_depth};
    EXPECT_EQ(charges_of(skin, given), charges_of(asked, given)) << i;
    ASSERT_TRUE(asked.charge_derivatives(derivatives));
  }
}

TEST(LiveChargeDerivatives, AreGivenByCAndCxxAndOfAHalfSkinByItsSymmetricMotions) {
  SkinData data = charged_sphere("coulomb");
  data.meshed_share = 0.5;
  const auto path = std::filesystem::temp_directory_path() / "ionskin_charge_derivatives.live";
  write_skin(path, data);
  ionskin_live::Skin skin(path.string());
  std::filesystem::remove(path);
  Skin own(data);
  charges_of(own, {0, charged_place, charged_depth});
  std::vector<double> expected(motions * own.charges()), told(expected.size());
  ASSERT_TRUE(own.charge_derivatives(expected));
  EXPECT_EQ(ionskin_live_charge_count(skin.handle()), own.charges());
  EXPECT_FALSE(skin.charge_derivatives(told.data()));
  skin.step(0, charged_place, ionskin_live::Height{-charged_depth});
  ASSERT_TRUE(skin.charge_derivatives(told.data()));
  for (std::size_t i = 0; i < told.size(); ++i) {
    const std::size_t motion = i % motions;
    EXPECT_EQ(std::isnan(told[i]), motion == 1 || motion == 3 || motion == 5) << i;
    EXPECT_TRUE(std::isnan(told[i]) || told[i] == expected[i]) << i;
  }
}

} // namespace
} // namespace ionskin::live
