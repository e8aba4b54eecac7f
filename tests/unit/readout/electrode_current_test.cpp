// SPDX-License-Identifier: Apache-2.0
#include "ionskin/readout/electrode_current.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace ionskin::readout {
namespace {

TEST(ElectrodeCurrent, IsTheChargeGainedOverTheStepDividedByIt) {
  const ElectrodeCurrents currents =
      electrode_currents({0.0, 0.5, 2.5}, {7.0, 8.0, 4.0}, {0.0, -2.0, 2.0});
  EXPECT_EQ(currents.top, (std::vector<double>{0.0, 2.0, -2.0}));
  EXPECT_EQ(currents.bottom, (std::vector<double>{0.0, -4.0, 2.0}));
  EXPECT_EQ(currents.difference, (std::vector<double>{0.0, 3.0, -2.0}));
  EXPECT_EQ(currents.common, (std::vector<double>{0.0, -1.0, 0.0}));
}

TEST(ElectrodeCurrent, IntegratesToTheChargeGainedSinceTheFirstRow) {
  const std::vector<double> time{0.0, 1e-5, 0.3, 0.31, 2.0};
  const std::vector<double> charge{1e-9, 5e-7, -2e-7, 4e-8, 3e-9};
  const std::vector<double> rates = step_rates(time, charge);
  double gained = 0;
  for (std::size_t row = 1; row < time.size(); ++row) {
    gained += rates[row] * (time[row] - time[row - 1]);
  }
  EXPECT_NEAR(gained, charge.back() - charge.front(), 1e-21);
}

TEST(ElectrodeCurrent, EmptyChargesHaveEmptyCurrents) {
  const std::vector<double> empty(3, std::numeric_limits<double>::quiet_NaN());
  const auto currents = electrode_currents({0, 1, 2}, empty, empty);
  for (std::size_t row = 0; row < 3; ++row) {
    EXPECT_TRUE(std::isnan(currents.top[row]));
    EXPECT_TRUE(std::isnan(currents.difference[row]));
  }
}

} // namespace
} // namespace ionskin::readout
