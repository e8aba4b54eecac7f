// SPDX-License-Identifier: Apache-2.0
#include "ionskin/circuits/amplifier.hpp"

#include "ionskin/circuits/noise_of_mean.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ionskin::circuits {
namespace {

constexpr double bandwidth = 100;
const double time_constant = 0.5 / (std::numbers::pi * bandwidth);

double figure(const InstrumentReading& reading, const std::string& name) {
  const auto found = std::ranges::find(reading.figures, name, &InstrumentFigure::name);
  return found == reading.figures.end() ? std::nan("") : found->value;
}

TEST(Amplifier, FollowsAStepOfCurrentExactlyOnAnySteps) {
  const double current = 2e-6;
  const std::vector<double> time{0, 1e-4, 3e-3, 3.1e-3, 0.02};
  std::vector<double> charge;
  for (const double t : time) {
    charge.push_back(current * t);
  }
  const InstrumentReading reading = Amplifier{bandwidth, 0, 0, 1}.read(time, charge);
  for (std::size_t row = 0; row < time.size(); ++row) {
    const double decay = std::exp(-time[row] / time_constant);
    EXPECT_NEAR(reading.current[row], current * (1 - decay), 1e-14 * current);
    EXPECT_NEAR(reading.charge[row], current * (time[row] - time_constant * (1 - decay)),
                1e-14 * charge.back());
  }
  EXPECT_EQ(figure(reading, "amplifier_clipped_time"), 0);
  EXPECT_TRUE(reading.warnings.empty());
}

TEST(Amplifier, ShowsTheNoiseThatItsInputHas) {
  const double density = 1e-9;
  const Amplifier amplifier{bandwidth, density, 0, 1};
  EXPECT_EQ(amplifier.input_noise().current, density);
  EXPECT_EQ(amplifier.input_noise().bandwidth, bandwidth);
  // Means of what it shows without a current, over 20000 intervals.
  const double interval = 2e-3;
  std::vector<double> time;
  for (int i = 0; i <= 20000; ++i) {
    time.push_back(interval * i);
  }
  const auto reading = amplifier.read(time, std::vector<double>(time.size(), 0.0));
  double sum = 0;
  for (std::size_t i = 1; i < time.size(); ++i) {
    sum += std::pow((reading.charge[i] - reading.charge[i - 1]) / interval, 2);
  }
  const double expected =
      noise_of_mean([&](double) { return density * density; }, {interval, bandwidth, 1e9});
  EXPECT_NEAR(std::sqrt(sum / 20000), expected, 0.03 * expected);
}

TEST(Amplifier, PassesTheWholeChargeOfAnImpulse) {
  const InstrumentReading reading =
      Amplifier{bandwidth, 0, 0, 1}.read({0, 0.1, 1}, {5e-9, 5e-9, 5e-9});
  EXPECT_DOUBLE_EQ(reading.current[0], 5e-9 / time_constant);
  EXPECT_EQ(reading.charge[0], 0);
  EXPECT_NEAR(reading.charge[2], 5e-9, 1e-21);
}

TEST(Amplifier, ClipsAndSaysForHowLong) {
  const InstrumentReading reading =
      Amplifier{bandwidth, 0, 1e-6, 1}.read({0, 1, 2, 3}, {0, 2e-6, 2.5e-6, -0.5e-6});
  EXPECT_DOUBLE_EQ(reading.current[1], 1e-6);
  EXPECT_NEAR(reading.current[2], 0.5e-6, 1e-15);
  EXPECT_DOUBLE_EQ(reading.current[3], -1e-6);
  // The output passes the range ln 2 time constants after 0 s, falls back ln 3 after 1 s, and
  // passes the other limit ln 1.75 after 2 s.
  EXPECT_DOUBLE_EQ(figure(reading, "amplifier_clipped_time"),
                   2 + time_constant * std::log(3 / 2.0 / 1.75));
  EXPECT_DOUBLE_EQ(figure(reading, "peak_amplifier_current"), 1e-6);
  ASSERT_EQ(reading.warnings.size(), 1U);
  EXPECT_NE(reading.warnings[0].find("the current reaches 3e-06 A, its range 1e-06 A, for 2 s"),
            std::string::npos);
  EXPECT_NEAR(reading.charge[1], 1e-6 * (1 + time_constant * (std::log(2.0) - 1)), 1e-20);
  EXPECT_NEAR(reading.charge[2] - reading.charge[1],
              0.5e-6 * (1 + time_constant * (std::log(3.0) + 1)), 1e-20);
}

TEST(Amplifier, ClipsForATimeThatDoesNotDependOnTheSteps) {
  // A pulse of 10 ms, resolved by its ends alone and by rows every 0.1 ms.
  const auto read = [](double step) {
    std::vector<double> time{0}, charge{0};
    for (int row = 1; row <= std::lround(0.05 / step); ++row) {
      time.push_back(row * step);
      charge.push_back(3e-6 * std::min(time.back(), 0.01));
    }
    return Amplifier{bandwidth, 0, 1e-6, 1}.read(time, charge);
  };
  const double settled = 3 * -std::expm1(-0.01 / time_constant);
  const double expected = 0.01 + time_constant * (std::log(settled) - std::log(1.5));
  EXPECT_NEAR(figure(read(0.01), "amplifier_clipped_time"), expected, 1e-12);
  EXPECT_NEAR(figure(read(1e-4), "amplifier_clipped_time"), expected, 1e-12);
  EXPECT_NEAR(read(0.01).charge.back(), read(1e-4).charge.back(), 1e-20);
}

TEST(Amplifier, NoiseHasTheVarianceOfItsBandAndTheDensityOfItsIntegral) {
  const double density = 3e-12;
  const int count = 20000;
  // Unequal steps, far shorter and far longer than the time constant.
  std::vector<double> time{0};
  for (int i = 0; i < count; ++i) {
    time.push_back(time.back() + (i % 2 == 0 ? 0.1 : 20.0) * time_constant);
  }
  const InstrumentReading reading =
      Amplifier{bandwidth, density, 0, 7}.read(time, std::vector<double>(time.size(), 0.0));
  double square = 0, jump = 0, charge = 0;
  for (std::size_t row = 2; row < time.size(); row += 2) {
    square += reading.current[row] * reading.current[row];
    jump += std::pow(reading.current[row - 1] - reading.current[row - 2], 2);
    charge += std::pow(reading.charge[row] - reading.charge[row - 1], 2);
  }
  const double pairs = count / 2.0, variance = density * density * bandwidth * std::numbers::pi / 2;
  // Standard error of a variance from 10000 samples: 1.4 %.
  EXPECT_NEAR(square / pairs / variance, 1, 0.06);
  EXPECT_NEAR(jump / pairs / (2 * variance * (1 - std::exp(-0.1))), 1, 0.06);
  // The charge walks at random over long times: S^2 T / 2, less an end effect of one time constant.
  EXPECT_NEAR(charge / pairs / (0.5 * density * density * 19 * time_constant), 1, 0.06);
}

TEST(Amplifier, TheSameSeedGivesTheSameNoise) {
  const std::vector<double> time{0, 1e-3, 5e-3}, charge{0, 0, 0};
  const auto once = Amplifier{bandwidth, 1e-12, 0, 3}.read(time, charge);
  EXPECT_EQ(once.current, (Amplifier{bandwidth, 1e-12, 0, 3}.read(time, charge).current));
  EXPECT_NE(once.current, (Amplifier{bandwidth, 1e-12, 0, 4}.read(time, charge).current));
}

} // namespace
} // namespace ionskin::circuits
