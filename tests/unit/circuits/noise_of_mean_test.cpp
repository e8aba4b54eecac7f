// SPDX-License-Identifier: Apache-2.0
#include "ionskin/circuits/noise_of_mean.hpp"

#include "ionskin/circuits/instruments.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace ionskin::circuits {
namespace {

/// S sqrt((1 - (tau/T) (1 - exp(-T/tau))) / (2 T)) with tau = 1/(2 pi B): the variance of the mean
/// of an Ornstein-Uhlenbeck process.
TEST(NoiseOfMean, OfWhiteNoiseIsInClosedForm) {
  const double mean_over = 0.01;
  for (const double turns : {0.01, 0.3, 1.0, 10.0, 1000.0}) {
    const double cut_off = turns / mean_over, steps = 2 * std::numbers::pi * turns;
    const double expected = 3.0 * std::sqrt((1 + std::expm1(-steps) / steps) / (2 * mean_over));
    const double found = noise_of_mean([](double) { return 9.0; }, {mean_over, cut_off, 1e9});
    EXPECT_NEAR(found / expected, 1, 2e-3) << turns;
  }
}

/// The noise of a resistor and a capacitor in parallel is 4 k T R / (1 + (w R C)^2): k T / C in
/// all, which a mean over a time far below R C does not lessen (Nyquist 1928).
TEST(NoiseOfMean, OfAResistorAndACapacitorIsTheEquipartitionValue) {
  const double resistance = 1e6, capacitance = 1e-6, energy = 1.380649e-23 * 300;
  const auto density = [&](double frequency) {
    const double ratio = 2 * std::numbers::pi * frequency * resistance * capacitance;
    return 4 * energy * resistance / (1 + ratio * ratio);
  };
  const double found = noise_of_mean(density, {1e-4, 1e6, 1e6});
  EXPECT_NEAR(found * found / (energy / capacitance), 1, 2e-3);
}

TEST(NoiseOfMean, LeavesOutWhatIsSlowerThanTheRecord) {
  // 1/f^2, whose integral from 1/record on is the record, far below the rate of the readings.
  const auto density = [](double frequency) { return 1 / (frequency * frequency); };
  EXPECT_NEAR(noise_of_mean(density, {1e-3, 1e6, 10.0}) / std::sqrt(10.0), 1, 1e-3);
}

TEST(Instruments, ConvertersFollowTheSignal) {
  const Instrument& one = instrument("ad8605"); // 16 bits
  const double step = 2 * 5e-6 / 65536;         // a range of 5 uA
  EXPECT_NEAR(quantisation_noise(one, 3e-6), step / std::sqrt(12.0), 1e-3 * step);
  EXPECT_NEAR(quantisation_noise(one, 7e-6) / quantisation_noise(one, 3e-6), 2, 1e-12);
  EXPECT_EQ(quantisation_noise(one, 0), 0);
  EXPECT_EQ(quantisation_noise(instrument("ideal"), 1), 0);
}

} // namespace
} // namespace ionskin::circuits
