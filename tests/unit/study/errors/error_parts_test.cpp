// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/errors/error_parts.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace ionskin::study {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
const double mesh_safety = safety(error_parts::mechanics_mesh, "mean_shear");

/// Signals of three rows in which the mean shear and the force of a run are multiplied.
Signals scaled_signals(double shear, double force) {
  Signals signals;
  const std::vector<double> zero(3, 0.0);
  signals.resolved.columns = {{"time", "s", {0, 1, 2}},
                              {"normal_force", "N", {0, 10 * force, 20 * force}},
                              {"mean_shear", "1", {0, 1e-3 * shear, 2e-3 * shear}},
                              {"mean_shear_rate", "1/s", {0, 1e-3 * shear, 1e-3 * shear}},
                              {"charge_top", "C", zero},
                              {"charge_bottom", "C", zero},
                              {"current_top", "A", zero},
                              {"current_bottom", "A", zero},
                              {"current_difference", "A", zero},
                              {"current_common", "A", zero}};
  signals.sampled.columns = {{"time", "s", {1, 2}},
                             {"current_top", "A", {0, 0}},
                             {"current_bottom", "A", {0, 0}},
                             {"current_difference", "A", {0, 0}},
                             {"current_common", "A", {0, 0}}};
  signals.metrics = {{"normal_force_slide", 20 * force, "N"},
                     {"mean_shear_slide", 2e-3 * shear, "1"}};
  return signals;
}

TEST(ErrorParts, SignalsCarryTheErrorsOfWaterAndOfThinLayers) {
  ErrorFloors floors;
  floors.thin_layers = 0.02;
  EXPECT_EQ(relative_floor(floors, "current_top", "A"), 0.02);
  EXPECT_EQ(relative_floor(floors, "normal_force", "N"), 0);
  floors.decoupling = 0.03;
  EXPECT_NEAR(relative_floor(floors, "charge_top", "C"), 0.05, 1e-15);
  EXPECT_EQ(relative_floor(floors, "normal_force", "N"), 0);
  EXPECT_EQ(relative_floor(floors, "signal_to_noise", "1"),
            relative_floor(floors, "current_top", "A"));
}

// A current over a noise that is known.
TEST(ErrorParts, ASignalToNoiseErrsAsItsCurrent) {
  Signals base = scaled_signals(1, 1), mesh = base;
  for (Signals* signals : {&base, &mesh}) {
    const double peak = signals == &base ? 1e-6 : 1.2e-6;
    signals->sampled.columns[3].values = {peak, -0.1 * peak};
    signals->resolved.columns[8].values = {0, peak, -0.1 * peak};
    signals->metrics.push_back({"peak_sampled_current_difference", peak, "A"});
    signals->metrics.push_back({"signal_to_noise", 1e3 * peak / 1e-6, "1"});
  }
  const auto errors =
      combine_errors(base, {{error_parts::mechanics_mesh, &base, &mesh}}, {}).relative;
  EXPECT_GT(errors.at("signal_to_noise"), 0.1);
  EXPECT_NEAR(errors.at("signal_to_noise"), errors.at("peak_sampled_current_difference"), 1e-12);
}

// The current of an open cell is rounding alone, and says nothing of the voltage.
TEST(ErrorParts, ASignalToNoiseOfAVoltageErrsAsTheVoltage) {
  Signals base = scaled_signals(1, 1), mesh = base;
  for (Signals* signals : {&base, &mesh}) {
    signals->metrics.push_back({"sample_noise", 1e-8, "V"});
    signals->metrics.push_back({"signal_to_noise", signals == &base ? 1000.0 : 1010.0, "1"});
  }
  base.sampled.columns[3].values = {0, 1e-18};
  mesh.sampled.columns[3].values = {1e-18, 0};
  const auto errors =
      combine_errors(base, {{error_parts::mechanics_mesh, &base, &mesh}}, {}).relative;
  EXPECT_LT(errors.at("signal_to_noise"), 0.02);
}

TEST(ErrorParts, AddUpToTheError) {
  const Signals base = scaled_signals(1, 1), mesh = scaled_signals(1.02, 1.01),
                path = scaled_signals(1.022, 1.01);
  const auto estimate = combine_errors(
      base, {{error_parts::mechanics_mesh, &base, &mesh}, {error_parts::path, &mesh, &path}}, {});
  const auto& parts = estimate.parts.at("mean_shear_slide");
  EXPECT_NEAR(parts.at("mechanics_mesh"), mesh_safety * 4e-5, 1e-12);
  EXPECT_GT(parts.at("path"), 3.9e-6);
  EXPECT_NEAR(estimate.relative.at("mean_shear_slide"),
              (parts.at("mechanics_mesh") + parts.at("path")) / 2e-3, 1e-12);
  EXPECT_NEAR(estimate.parts.at("normal_force_slide").at("mechanics_mesh"), mesh_safety * 0.2,
              1e-9);
}

TEST(ErrorParts, AMeanShearErrsNoLessThanTheForce) {
  const Signals base = scaled_signals(1, 1), mesh = scaled_signals(1.001, 1.02);
  const auto estimate = combine_errors(base, {{error_parts::mechanics_mesh, &base, &mesh}}, {});
  EXPECT_NEAR(estimate.relative.at("mean_shear_slide"), mesh_safety * 0.02, 1e-9);
  EXPECT_NEAR(estimate.signals.column("mean_shear").values.back(), mesh_safety * 0.02 * 2e-3,
              1e-12);
  EXPECT_NEAR(estimate.relative.at("normal_force_slide"), mesh_safety * 0.02, 1e-9);
}

// Under a prescribed force friction is the same on every mesh, and so are the works.
TEST(ErrorParts, TheWorksErrAsTheTangentialForceAndNotAsTheShear) {
  Signals base = scaled_signals(1, 1), mesh = scaled_signals(1.05, 1);
  for (Signals* signals : {&base, &mesh}) {
    const double force = signals == &base ? 1 : 1.01;
    signals->resolved.columns.push_back({"tangential_force", "N", {0, force, force}});
    signals->metrics.push_back({"external_work", 1e-3, "J"});
    signals->metrics.push_back({"friction_work", 1e-3, "J"});
  }
  const auto errors =
      combine_errors(base, {{error_parts::mechanics_mesh, &base, &mesh}}, {}).relative;
  EXPECT_NEAR(errors.at("external_work"), 0.01, 1e-9); // made at the edges of the contact
  EXPECT_NEAR(errors.at("friction_work"), 0.01, 1e-9);
  EXPECT_GT(errors.at("mean_shear_slide"), 0.02);
}

TEST(ErrorParts, ADifferenceThatHappensToVanishIsNoSmallError) {
  const Signals base = scaled_signals(1, 1);
  Signals mesh = scaled_signals(1.01, 1);
  mesh.metrics[1].value = base.metrics[1].value; // the mean shear is off at every other instant
  const auto estimate = combine_errors(base, {{error_parts::mechanics_mesh, &base, &mesh}}, {});
  EXPECT_GE(estimate.relative.at("mean_shear_slide"), mesh_safety * 0.0099);
}

TEST(ErrorParts, MeshesAndStepsCountTwiceWhatRichardsonMakesOfThem) {
  const double twice = 2 / (std::pow(2.0, 1.8) - 1); // at the order that verification asserts
  for (const char* part :
       {error_parts::mechanics_mesh, error_parts::transport_grid, error_parts::time_steps}) {
    EXPECT_NEAR(safety(part, "mean_shear"), twice, 1e-12) << part;
  }
  EXPECT_EQ(safety(error_parts::path, "mean_shear"), 1);
  EXPECT_EQ(safety(error_parts::handover, "mean_shear"), 1);
}

TEST(ErrorParts, WhatHangsOnEdgesCountsTheWholeDifferenceOfTwoMeshes) {
  for (const char* name : {"p99_shear_slide", "shear_first_moment_touchdown", "contact_area_slide",
                           "stick_fraction_touchdown"}) {
    EXPECT_EQ(safety(error_parts::mechanics_mesh, name), 1) << name;
    EXPECT_LT(safety(error_parts::time_steps, name), 1) << name;
  }
}

TEST(ErrorParts, AnUpperPercentileErrsAsTheOtherOneAndNotAsTheLargestValue) {
  Signals base = scaled_signals(1, 1), mesh = scaled_signals(1, 1);
  base.resolved.columns.push_back({"p99_shear", "1", {0, 0.02, 0.02}});
  mesh.resolved.columns.push_back(base.resolved.columns.back());
  base.metrics.push_back({"p99_shear_slide", 0.02, "1"});
  base.metrics.push_back({"element_max_shear_slide", 0.04, "1"});
  base.metrics.push_back({"p95_shear_slide", 0.01, "1"});
  mesh.metrics = base.metrics;
  mesh.metrics[3].value = 0.08;
  mesh.metrics[4].value = 0.0125;
  const auto estimate = combine_errors(base, {{error_parts::mechanics_mesh, &base, &mesh}}, {});
  EXPECT_NEAR(estimate.relative.at("p99_shear_slide"), 0.25, 1e-12);
}

TEST(ErrorParts, WhatIsNotANumberIsNotEstimated) {
  const Signals base = scaled_signals(1, 1);
  Signals mesh = scaled_signals(1.01, 1.01);
  mesh.metrics[0].value = nan;
  const auto estimate = combine_errors(base, {{error_parts::mechanics_mesh, &base, &mesh}}, {});
  EXPECT_FALSE(estimate.relative.contains("normal_force_slide"));
  EXPECT_EQ(estimate.not_estimated.at("normal_force_slide"), not_a_number);
  EXPECT_TRUE(estimate.relative.contains("mean_shear_slide"));
}

TEST(ErrorParts, FewReadingsOfTheOnsetAreNoDefect) {
  Signals base = scaled_signals(1, 1);
  base.metrics.push_back({"precursor_correlation_common", 0.9, "1"});
  Signals mesh = base;
  mesh.metrics.back().value = nan;
  const auto estimate = combine_errors(base, {{error_parts::mechanics_mesh, &base, &mesh}}, {});
  EXPECT_EQ(estimate.not_estimated.at("precursor_correlation_common"), too_few_readings);
}

TEST(ErrorParts, AuditsAndWhatRoundingMakesHaveNone) {
  Signals base = scaled_signals(1, 1);
  base.metrics.push_back({"equilibrium_residual", 1e-12, "1"});
  base.metrics.push_back({"peak_sampled_current_top", 1e-16, "A"});
  const Signals mesh = base;
  const auto estimate = combine_errors(base, {{error_parts::mechanics_mesh, &base, &mesh}},
                                       {.charge = 1e-16, .sample_interval = 0.01});
  EXPECT_TRUE(estimate.not_estimated.contains("equilibrium_residual"));
  EXPECT_EQ(estimate.not_estimated.at("peak_sampled_current_top"), "rounding alone makes it");
}

TEST(ErrorParts, ThePathLeavesNoLessThanItsInterpolation) {
  const Signals base = scaled_signals(1, 1);
  const auto estimate = combine_errors(base, {{error_parts::path, &base, &base}}, {.path = 1e-4});
  EXPECT_DOUBLE_EQ(estimate.parts.at("normal_force_slide").at("path"), 20e-4);
}

TEST(ErrorParts, TheMeshLeavesNoLessThanItsCells) {
  const Signals base = scaled_signals(1, 1);
  const auto estimate = combine_errors(base, {{error_parts::mechanics_mesh, &base, &base}},
                                       {.cells = {{"normal_force_slide", 3, "N"}}});
  EXPECT_DOUBLE_EQ(estimate.parts.at("normal_force_slide").at("mechanics_mesh"), 3);
  EXPECT_EQ(estimate.parts.at("mean_shear_slide").at("mechanics_mesh"), 0);
}

TEST(ErrorParts, WhatIsGivenHasTheErrorOfItsSolverAlone) {
  const Signals base = scaled_signals(1, 1), mesh = scaled_signals(1.01, 1.02);
  const ImposedErrors imposed{{{"normal_force_slide", 2e-7, "N"}},
                              {{"normal_force", "N", {nan, nan, 2e-7}}}};
  const auto estimate = combine_errors(base, {{error_parts::mechanics_mesh, &base, &mesh}},
                                       {.path = 1e-4, .imposed = imposed});
  EXPECT_DOUBLE_EQ(estimate.relative.at("normal_force_slide"), 1e-8);
  EXPECT_EQ(estimate.parts.at("normal_force_slide").at("mechanics_mesh"), 0);
  EXPECT_EQ(estimate.parts.at("normal_force_slide").at("path"), 2e-7);
  const auto& band = estimate.signals.column("normal_force").values;
  EXPECT_EQ(band[2], 2e-7);
  EXPECT_NEAR(band[1], mesh_safety * 0.4, 1e-12); // the slider is on its way to the force
  EXPECT_GT(estimate.relative.at("mean_shear_slide"), 0);
}

TEST(ErrorParts, BandsHoldTheDifferenceOfTheRowsNearby) {
  const Signals base = scaled_signals(1, 1), mesh = scaled_signals(1.01, 1);
  const auto estimate = combine_errors(base, {{error_parts::mechanics_mesh, &base, &mesh}}, {});
  EXPECT_EQ(estimate.signals.column("time").values, base.resolved.column("time").values);
  const auto& band = estimate.signals.column("mean_shear").values;
  for (const double half_width : band) {
    EXPECT_NEAR(half_width, mesh_safety * 2e-5, 1e-12);
  }
}

} // namespace
} // namespace ionskin::study
