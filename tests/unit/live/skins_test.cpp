// SPDX-License-Identifier: Apache-2.0
#include "allocation_counter.hpp"
#include "ionskin/live/batch/skins.hpp"
#include "small_skin.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>

namespace ionskin::live {
namespace {

constexpr std::size_t count = 11; // no multiple of the lanes
constexpr int steps = 40;

/// Environments that slide at their own speeds; some are lifted for a while.
class LiveSkins : public testing::Test {
protected:
  LiveSkins() {
    data.lowest_friction = 0.1;
    data.highest_friction = 0.5;
    std::iota(columns.begin(), columns.end(), 0u);
  }
  std::array<double, 2> place(std::size_t i, int step) const {
    return {2e-3 + 1e-5 * step * static_cast<double>(i % 5), 1e-3};
  }
  double height(std::size_t i, int step) const {
    return (i + static_cast<std::size_t>(step) / 10) % 4 == 0 ? 1e-6
                                                              : -1e-7 * static_cast<double>(2 + i);
  }
  /// The signals of all steps, environments from `first` to before `last` by a worker in turns.
  template <class Value> std::vector<Value> run(Skins& skins, std::size_t block) {
    std::vector<double> times(count);
    std::vector<Value> positions(2 * count), loads(count), signals(count * columns.size()), all;
    for (int at = 0; at < steps; ++at) {
      for (std::size_t i = 0; i < count; ++i) {
        times[i] = 1e-3 * at;
        positions[2 * i] = static_cast<Value>(place(i, at)[0]);
        positions[2 * i + 1] = static_cast<Value>(place(i, at)[1]);
        loads[i] = static_cast<Value>(height(i, at));
      }
      for (std::size_t first = 0; first < count; first += block) {
        skins.step<Value>(first / block % 2, first, std::min(count, first + block),
                          {times.data(), positions.data(), false, loads.data(), columns,
                           signals.data(), flags.data()});
      }
      all.insert(all.end(), signals.begin(), signals.end());
    }
    return all;
  }

  SkinData data = small_skin();
  Skin like{data};
  std::vector<std::uint32_t> columns = std::vector<std::uint32_t>(like.names().size()),
                             flags{std::vector<std::uint32_t>(count)};
};

TEST_F(LiveSkins, AreTheSameBitsAsSingleSkins) {
  Skins skins(data, like, count, 2);
  for (std::size_t i = 0; i < count; ++i) {
    ASSERT_TRUE(skins.set_friction(i, 0.1 + 0.03 * static_cast<double>(i)));
  }
  EXPECT_FALSE(skins.set_friction(0, 0.6));
  const std::vector<double> together = run<double>(skins, 4);
  std::vector<double> signals(columns.size());
  for (std::size_t i = 0; i < count; ++i) {
    Skin skin(data);
    skin.set_friction(0.1 + 0.03 * static_cast<double>(i));
    for (int at = 0; at < steps; ++at) {
      skin.step(1e-3 * at, place(i, at), false, height(i, at), signals);
      for (std::size_t k = 0; k < columns.size(); ++k) {
        ASSERT_EQ(together[(static_cast<std::size_t>(at) * count + i) * columns.size() + k],
                  signals[k])
            << i << " " << at << " " << like.names()[k];
      }
    }
  }
}

TEST_F(LiveSkins, AnyDivisionGivesTheSameBits) {
  const auto divided = [&](std::size_t block) {
    Skins skins(data, like, count, 2);
    for (std::size_t i = 0; i < count; ++i) {
      skins.noise(i) = {1e-9, i, 0};
    }
    return run<float>(skins, block);
  };
  const std::vector<float> whole = divided(count);
  EXPECT_EQ(divided(1), whole);
  EXPECT_EQ(divided(3), whole);
}

TEST_F(LiveSkins, NoiseIsWhiteAndReplayed) {
  Skins quiet(data, like, count, 2), noisy(data, like, count, 2), again(data, like, count, 2);
  constexpr double deviation = 2e-9;
  for (std::size_t i = 0; i < count; ++i) {
    noisy.noise(i) = again.noise(i) = {deviation, 1000 + i, 0};
  }
  const std::vector<double> without = run<double>(quiet, count), with = run<double>(noisy, count);
  EXPECT_EQ(run<double>(again, 2), with);
  double squares = 0, products = 0, last = 0;
  std::size_t numbers = 0;
  for (std::size_t at = 0; at < with.size(); ++at) {
    const std::string& name = like.names()[at % columns.size()];
    const double noise = with[at] - without[at];
    if (name == "current_top") {
      squares += noise * noise;
      products += noise * last;
      last = noise;
      ++numbers;
      EXPECT_NEAR(with[at + 2], (with[at] - with[at + 1]) / 2, 1e-20); // half the difference
    } else if (!name.starts_with("current_")) {
      EXPECT_EQ(noise, 0) << name;
    }
  }
  const double n = static_cast<double>(numbers); // three deviations of each estimate
  EXPECT_NEAR(squares / n / (deviation * deviation), 1, 3 * std::sqrt(2 / n));
  EXPECT_NEAR(products / n / (deviation * deviation), 0, 3 / std::sqrt(n));
}

TEST_F(LiveSkins, OneIsRefusedOrResetWithoutTheOthers) {
  Skins skins(data, like, 2, 1);
  std::vector<double> times{0, 0}, positions{2e-3, 1e-3, 2e-3, 1e-3}, loads{-5e-7, -5e-7},
      signals(2 * columns.size());
  const auto step = [&] {
    skins.step<double>(0, 0, 2,
                       {times.data(), positions.data(), false, loads.data(), columns,
                        signals.data(), flags.data()});
  };
  skins.noise(1) = {1e-9, 7, 0};
  step();
  const std::vector<double> state(skins.state(1).begin(), skins.state(1).end());
  const std::vector<double> told(signals.begin() + static_cast<std::ptrdiff_t>(columns.size()),
                                 signals.end());
  times = {1, 1};
  loads[1] = std::numeric_limits<double>::quiet_NaN();
  const std::size_t before = allocations();
  step();
  EXPECT_EQ(allocations(), before);
  EXPECT_EQ(flags[0], 0u);
  EXPECT_EQ(flags[1], flag::refused);
  EXPECT_TRUE(std::equal(told.begin(), told.end(),
                         signals.begin() + static_cast<std::ptrdiff_t>(columns.size())));
  EXPECT_TRUE(std::ranges::equal(skins.state(1), state));
  skins.reset(0);
  times = {0, 1};
  loads = {-5e-7, -5e-7};
  step(); // time of the first begins anew
  EXPECT_EQ(flags[0], 0u);
  EXPECT_TRUE(skins.restore(0, state));
  EXPECT_TRUE(std::ranges::equal(skins.state(0), state));
  EXPECT_FALSE(skins.restore(0, std::span(state).first(3)));
}

} // namespace
} // namespace ionskin::live
