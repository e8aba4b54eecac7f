// SPDX-License-Identifier: Apache-2.0
#include "ionskin/readout/circuit.hpp"

#include "ionskin/readout/sampling.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace ionskin::readout {
namespace {

constexpr double bandwidth = 1e3, density = 1e-9, interval = 0.01;

circuits::Circuit amplifier(double noise) {
  return circuits::circuit("amplifier", {{"amplifier_bandwidth", bandwidth},
                                         {"amplifier_noise_density", noise},
                                         {"amplifier_range", 0},
                                         {"noise_seed", 1}});
}

TEST(SampledReading, WithoutNoiseIsTheFilteredCurrentAtRowsAndInTheMean) {
  // The current jumps at 0.1 s, between the ends of intervals.
  const std::vector<double> time{0, 0.1, 0.104, 0.35}, charge{0, 0, 4e-9, 4e-9 + 246e-9};
  const SampledReading reading = sampled_reading(amplifier(0), time, charge, interval);
  const circuits::InstrumentReading plain = amplifier(0).read(time, charge);
  ASSERT_EQ(reading.at_rows.current.size(), time.size());
  for (std::size_t row = 0; row < time.size(); ++row) {
    EXPECT_NEAR(reading.at_rows.current[row], plain.current[row], 1e-18);
    EXPECT_NEAR(reading.at_rows.charge[row], plain.charge[row], 1e-20);
  }
  ASSERT_EQ(reading.mean_current.size(), 35u);
  EXPECT_EQ(reading.mean_current[9], 0);
  const double lag = 0.5 / (std::numbers::pi * bandwidth); // s
  EXPECT_NEAR(reading.mean_current[10], 1e-6 * (interval - lag) / interval, 1e-12);
  EXPECT_NEAR(reading.mean_current[20], 1e-6, 1e-15);
  EXPECT_NEAR(reading.charge.back(), plain.charge.back(), 1e-18);
  const SignalTable table = sampled_instrument_signals(time, interval, reading);
  EXPECT_EQ(table.column("time").values,
            sample_table(instrument_signals(time, plain), interval).column("time").values);
}

TEST(SampledReading, HasWhiteNoiseInEachIntervalHoweverLongTheSteps) {
  const std::vector<double> time{0, 40, 100}, charge(3, 0.0);
  const std::vector<double> means =
      sampled_reading(amplifier(density), time, charge, interval).mean_current;
  ASSERT_EQ(means.size(), 10000u);
  double squares = 0, neighbours = 0;
  for (std::size_t i = 1; i < means.size(); ++i) {
    squares += means[i] * means[i];
    neighbours += means[i] * means[i - 1];
  }
  const double expected = density * std::sqrt(0.5 / interval);
  EXPECT_NEAR(std::sqrt(squares / 9999) / expected, 1, 0.03);
  EXPECT_LT(std::abs(neighbours / squares), 0.05);
}

} // namespace
} // namespace ionskin::readout
