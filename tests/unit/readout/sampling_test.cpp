// SPDX-License-Identifier: Apache-2.0
#include "ionskin/readout/sampling.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace ionskin::readout {
namespace {

SignalTable charges(std::vector<double> time, std::vector<double> top, std::vector<double> bottom) {
  SignalTable table;
  table.columns = {{"time", "s", std::move(time)},
                   {"charge_top", "C", std::move(top)},
                   {"charge_bottom", "C", std::move(bottom)}};
  return table;
}

TEST(Sampling, DividesTheChargeGainedByTheInterval) {
  const SignalTable sampled =
      sample_currents(charges({0, 0.25, 1, 2}, {0, 1, 1, 3}, {5, 5, 4, 4}), 0.5);
  EXPECT_EQ(sampled.column("time").values, (std::vector<double>{0.5, 1.0, 1.5, 2.0}));
  EXPECT_EQ(sampled.column("current_top").values, (std::vector<double>{2, 0, 2, 2}));
  const std::vector<double>& bottom = sampled.column("current_bottom").values;
  EXPECT_NEAR(bottom[0], -2.0 / 3, 1e-14);
  EXPECT_NEAR(bottom[1], -4.0 / 3, 1e-14);
  EXPECT_EQ(bottom[2], 0);
  EXPECT_NEAR(sampled.column("current_difference").values[0], 4.0 / 3, 1e-14);
  EXPECT_NEAR(sampled.column("current_common").values[0], 2.0 / 3, 1e-14);
}

TEST(Sampling, LeavesTheImpulseOfTheFirstRowOut) {
  const SignalTable sampled = sample_currents(charges({0, 1}, {9, 10}, {9, 9}), 1.0);
  EXPECT_EQ(sampled.column("current_top").values, (std::vector<double>{1}));
}

TEST(Sampling, DropsAnIncompleteLastInterval) {
  const SignalTable sampled = sample_currents(charges({0, 1}, {0, 1}, {0, 0}), 0.3);
  ASSERT_EQ(sampled.column("time").values.size(), 3u);
  EXPECT_NEAR(sampled.column("time").values.back(), 0.9, 1e-15);
}

TEST(Sampling, KeepsTheLastIntervalDespiteRounding) {
  const SignalTable sampled = sample_currents(charges({0, 0.3}, {0, 3}, {0, 0}), 0.1);
  ASSERT_EQ(sampled.column("time").values.size(), 3u);
  EXPECT_NEAR(sampled.column("current_top").values.back(), 10.0, 1e-12);
}

TEST(Sampling, OfARunShorterThanOneIntervalIsEmpty) {
  EXPECT_TRUE(sample_currents(charges({0, 1}, {0, 1}, {0, 0}), 2.0).column("time").values.empty());
}

TEST(Sampling, OfATableTakesMeansOfVoltagesAndGainsOfCharges) {
  SignalTable table;
  table.columns = {{"time", "s", {0, 0.5, 2}},
                   {"voltage", "V", {0, 1, 4}},
                   {"current", "A", {0, 99, 99}},
                   {"charge", "C", {0, 1, 4}},
                   {"current_top_r1c1", "A", {0, 99, 99}},
                   {"charge_top_r1c1", "C", {0, 3, 3}}};
  const SignalTable sampled = sample_table(table, 1.0);
  EXPECT_EQ(sampled.column("time").values, (std::vector<double>{1, 2}));
  EXPECT_EQ(sampled.column("voltage").values, (std::vector<double>{1, 3}));
  EXPECT_EQ(sampled.column("current").values, (std::vector<double>{2, 2}));
  EXPECT_EQ(sampled.column("charge").values, (std::vector<double>{2, 4}));
  EXPECT_EQ(sampled.column("current_top_r1c1").values, (std::vector<double>{3, 0}));
}

} // namespace
} // namespace ionskin::readout
