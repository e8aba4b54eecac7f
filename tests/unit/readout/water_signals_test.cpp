// SPDX-License-Identifier: Apache-2.0
#include "ionskin/readout/water_signals.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace ionskin::readout {
namespace {

SignalTable example() {
  return water_signals({.time = {0, 1, 2},
                        .pressure_top = {0, 3e4, 1e4},
                        .pressure_bottom = {0, 1e4, 2e4},
                        .streaming_voltage = {0, -9e-6, 4e-6},
                        .dilution_voltage = {0, -1e-6, -2e-6},
                        .largest_pressure = {0, 5e4, 3e4},
                        .largest_drive = {0, 0.2, 0.1},
                        .outflow_top = {0, 2e-15, 3e-15},
                        .outflow_bottom = {0, 0, 0},
                        .dragged_top = {0, 1e-15, 1e-15},
                        .dragged_bottom = {0, 0, 0},
                        .dragged_difference = {0, 40, 20},
                        .holding_pressure = {0, 0, 0}});
}

double value_of(const std::vector<Metric>& metrics, const std::string& name) {
  const auto found = std::ranges::find(metrics, name, &Metric::name);
  return found == metrics.end() ? -1 : found->value;
}

TEST(WaterSignals, AddUp) {
  const SignalTable table = example();
  EXPECT_EQ(table.column("pressure_difference").values, (std::vector<double>{0, 2e4, -1e4}));
  EXPECT_DOUBLE_EQ(table.column("open_circuit_voltage").values[1], -10e-6);
  EXPECT_EQ(table.column("open_circuit_voltage").unit, "V");
  EXPECT_EQ(table.column("water_outflow_top").values[2], 3e-15);
  EXPECT_EQ(table.column("dragged_outflow_top").unit, "m3");
}

TEST(WaterSignals, TellWhatHoldsACompressionOnlyWhereOneIsHeld) {
  const auto has = [](const SignalTable& table) {
    return std::ranges::count(table.columns, "holding_pressure", &Signal::name);
  };
  EXPECT_EQ(has(example()), 0);
  EXPECT_EQ(has(water_signals({.time = {0}, .holding_pressure = {1e5}})), 1);
}

TEST(WaterSignals, MetricsArePeaksAndWhatANewtonGives) {
  const auto metrics = water_metrics(example(), 2.0, 1e-4);
  EXPECT_DOUBLE_EQ(value_of(metrics, "peak_open_circuit_voltage"), 10e-6);
  EXPECT_DOUBLE_EQ(value_of(metrics, "streaming_share"), 0.9);
  EXPECT_DOUBLE_EQ(value_of(metrics, "open_circuit_voltage_per_newton"), 5e-6);
  EXPECT_DOUBLE_EQ(value_of(metrics, "pressure_asymmetry"), 1.0);
  EXPECT_DOUBLE_EQ(value_of(metrics, "peak_pore_pressure"), 5e4);
  EXPECT_EQ(value_of(water_metrics(example(), {}, 1e-4), "pressure_asymmetry"), -1);
}

TEST(WaterSignals, NothingHasNoShareOfStreaming) {
  SignalTable still = example();
  for (Signal& column : still.columns) {
    std::ranges::fill(column.values, 0.0);
  }
  EXPECT_EQ(value_of(water_metrics(still, {}, 1e-4), "streaming_share"), -1);
}

} // namespace
} // namespace ionskin::readout
