// SPDX-License-Identifier: Apache-2.0
#include "ionskin/readout/slip_precursor.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace ionskin::readout {
namespace {

/// A current of 2 A until the first micro-slip at 1 s, that falls to 0 at full slip at 2 s as the
/// stuck share does.
struct Falling {
  std::vector<double> time, charge, share;
  SlipOnset onset{0.5, 1, 2.0, 0.01, 0.01};

  Falling() {
    for (int i = 0; i <= 300; ++i) {
      const double t = 0.01 * i, slipping = t <= 1 ? 0 : t < 2 ? t - 1 : 1;
      time.push_back(t);
      charge.push_back(2 * t - (t <= 1 ? 0 : t < 2 ? slipping * slipping : 1 + 2 * (t - 2)));
      share.push_back(1 - slipping);
    }
  }
};

TEST(SlipPrecursor, IsHowFarAReadingDepartsBeforeFullSlip) {
  const Falling signal;
  const double interval = 0.1;
  const auto found =
      slip_precursor(signal.time, signal.charge, signal.share, signal.onset, interval, 0.1);
  // The mean over the last 0.1 s lags by half of that.
  EXPECT_NEAR(found.departure.value(), 2 * (1 - 0.05), 1e-9);
  EXPECT_NEAR(found.charge, 1, 1e-9);
  ASSERT_TRUE(found.lead_time);
  EXPECT_NEAR(*found.lead_time, 1 - (0.3 / 2 + 0.05), 1e-3);
  ASSERT_TRUE(found.correlation);
  EXPECT_NEAR(*found.correlation, 1, 1e-9);
}

TEST(SlipPrecursor, IsNotSeenWithinTheNoise) {
  const Falling signal;
  const auto found =
      slip_precursor(signal.time, signal.charge, signal.share, signal.onset, 0.1, 1.0);
  EXPECT_FALSE(found.lead_time);
  EXPECT_NEAR(found.departure.value(), 1.9, 1e-9);
}

TEST(SlipPrecursor, HasTheSignOfItsCurrent) {
  Falling signal;
  for (double& charge : signal.charge) {
    charge *= -1;
  }
  const auto found =
      slip_precursor(signal.time, signal.charge, signal.share, signal.onset, 0.1, 0.1);
  EXPECT_NEAR(*found.correlation, -1, 1e-9);
  EXPECT_NEAR(found.departure.value(), 1.9, 1e-9);
}

TEST(SlipPrecursor, OfAConstantCurrentCorrelatesWithNothing) {
  Falling signal;
  for (std::size_t i = 0; i < signal.time.size(); ++i) {
    signal.charge[i] = 0;
  }
  const auto found =
      slip_precursor(signal.time, signal.charge, signal.share, signal.onset, 0.1, 0.0);
  EXPECT_FALSE(found.correlation);
  EXPECT_FALSE(found.lead_time);
  EXPECT_EQ(found.departure, 0.0);
  EXPECT_EQ(found.charge, 0);
}

TEST(SlipPrecursor, CountsReadingsOfTheSlideAlone) {
  const Falling signal;
  // The slide began at 0.5 s: the first reading over 0.8 s that counts ends at 1.3 s.
  const auto found =
      slip_precursor(signal.time, signal.charge, signal.share, signal.onset, 0.8, 1e-3);
  EXPECT_NEAR(found.departure.value(), (0.96 - 0.09) / 0.8, 1e-9);
  ASSERT_TRUE(found.lead_time);
  EXPECT_LT(*found.lead_time, 0.7);
  const auto slow =
      slip_precursor(signal.time, signal.charge, signal.share, signal.onset, 1.5, 1e-3);
  EXPECT_FALSE(slow.departure);
  EXPECT_FALSE(slow.lead_time);
  EXPECT_NEAR(slow.correlation.value(), 1, 1e-9);
}

} // namespace
} // namespace ionskin::readout
