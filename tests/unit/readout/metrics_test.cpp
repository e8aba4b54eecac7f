// SPDX-License-Identifier: Apache-2.0
#include "ionskin/readout/metrics.hpp"

#include "ionskin/readout/sampling.hpp"
#include "ionskin/readout/signal_table.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>

namespace ionskin::readout {
namespace {

SignalTable run() {
  SignalInputs inputs;
  inputs.time = {0, 1, 3, 4};
  inputs.normal_force = {0, 60, 64, 0};
  inputs.tangential_force = {0, 1, 20, 0};
  inputs.mean_shear = {0, 0.2, 0.4, 0};
  inputs.rms_shear = inputs.shear_first_moment = {0, 0, 0, 0};
  inputs.p99_shear = {0, 1, 3, 0};
  inputs.charge_top = {1, 3, -3, -3};
  inputs.charge_bottom = {2, 2, 2, 3};
  return build_signal_table(inputs);
}

std::map<std::string, Metric> by_name(const std::vector<Metric>& metrics) {
  std::map<std::string, Metric> result;
  for (const Metric& metric : metrics) {
    result[metric.name] = metric;
  }
  return result;
}

TEST(Metrics, NamedQuantitiesOfARunByHand) {
  const SignalTable signals = run();
  auto metrics =
      by_name(signal_metrics(signals, sample_currents(signals, 2.0), NamedInstants{1, 2}));
  EXPECT_EQ(metrics["normal_force_touchdown"].value, 60);
  EXPECT_EQ(metrics["normal_force_touchdown"].unit, "N");
  EXPECT_EQ(metrics["normal_force_slide"].value, 62);
  EXPECT_NEAR(metrics["tangential_force_slide"].value, 10.5, 1e-12);
  EXPECT_EQ(metrics["mean_shear_touchdown"].value, 0.2);
  EXPECT_NEAR(metrics["mean_shear_slide"].value, 0.3, 1e-15);
  EXPECT_EQ(metrics["p99_shear_slide"].value, 2);
  EXPECT_EQ(metrics["peak_mean_shear"].value, 0.4);
  EXPECT_NEAR(metrics["time_mean_shear"].value, (0.1 + 0.6 + 0.2) / 4, 1e-15);
  const double square = 0.04 / 3 + 2 * (0.04 + 0.08 + 0.16) / 3 + 0.16 / 3;
  EXPECT_NEAR(metrics["rms_mean_shear"].value, std::sqrt(square / 4), 1e-15);
  EXPECT_EQ(metrics["peak_current_top"].value, 3);
  EXPECT_EQ(metrics["peak_current_bottom"].value, 1);
  EXPECT_EQ(metrics["peak_current_difference"].value, 1.5);
  EXPECT_NEAR(metrics["rms_current_top"].value, std::sqrt((4.0 + 18.0) / 4), 1e-15);
  EXPECT_EQ(metrics["peak_sampled_current_top"].value, 1.5);
  EXPECT_EQ(metrics["peak_sampled_current_top"].unit, "A");
  EXPECT_EQ(metrics["initial_charge_top"].value, 1);
}

TEST(Metrics, RunsFromAStrainFileHaveNoMotionQuantities) {
  const SignalTable signals = run();
  auto metrics = by_name(signal_metrics(signals, sample_currents(signals, 2.0), std::nullopt));
  EXPECT_EQ(metrics.count("normal_force_touchdown"), 0u);
  EXPECT_EQ(metrics.count("mean_shear_slide"), 0u);
  EXPECT_EQ(metrics.count("rms_current_difference"), 1u);
}

TEST(Metrics, RmsOfALinearRampIsExactOnAnyRows) {
  EXPECT_NEAR(rms_linear({0, 1}, {0, 1}), std::sqrt(1.0 / 3), 1e-15);
  EXPECT_NEAR(rms_linear({0, 0.1, 1}, {0, 0.1, 1}), std::sqrt(1.0 / 3), 1e-15);
}

TEST(Metrics, PeakIsOfTheMagnitudeAndSkipsEmptyEntries) {
  EXPECT_EQ(peak_magnitude({1, NAN, -3, 2}), 3);
  EXPECT_EQ(peak_magnitude({}), 0);
}

TEST(Metrics, ChargeIdentityErrorIsTheWorstRowOverTheScale) {
  EXPECT_NEAR(charge_identity_error({1, 2}, {1, 2.5}, {2, 4}, 5), 0.1, 1e-15);
  EXPECT_EQ(charge_identity_error({0, 1}, {0, -1}, {0, 0}, 0), 0);
  const double infinite = std::numeric_limits<double>::infinity();
  EXPECT_EQ(charge_identity_error({0, 1}, {0, 0}, {0, 0}, 0), infinite);
  EXPECT_EQ(charge_identity_error({NAN, 0}, {0, 0}, {0, 0}, 1), infinite);
}

} // namespace
} // namespace ionskin::readout
