// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/errors/imposed_quantities.hpp"

#include "ionskin/mechanics/output/contact_solution.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace ionskin::study {
namespace {

/// A slider goes from 1 mm above the skin to 2 N within 1 s, on to 3 N and 1 mm further at 2 s, off
/// again at 3 s.
Case pressed_case() {
  Case input;
  input.motion.kind = MotionKind::waypoints;
  input.motion.waypoints = {{0, {1e-3, 2e-3}, 1e-3, std::nullopt},
                            {1, {1e-3, 2e-3}, std::nullopt, 2.0},
                            {2, {2e-3, 2e-3}, std::nullopt, 3.0},
                            {3, {2e-3, 2e-3}, 1e-3, std::nullopt}};
  return input;
}

/// Rows twice a second, as a solver leaves them that misses the force at 1.5 s.
Signals pressed_signals() {
  Signals signals;
  signals.resolved.columns = {{"time", "s", {0, 0.5, 1, 1.5, 2, 2.5, 3}},
                              {"normal_force", "N", {0, 0.7, 2, 2.5 + 1e-5, 3, 0.4, 0}},
                              {"slider_z", "m", {1e-3, 2e-4, -1e-6, -1.2e-6, -1.4e-6, 3e-4, 1e-3}},
                              {"slider_x", "m", {1e-3, 1e-3, 1e-3, 1.5e-3, 2e-3, 2e-3, 2e-3}},
                              {"slider_y", "m", std::vector<double>(7, 2e-3)},
                              {"stick_share", "1", std::vector<double>(7, 0.5)}};
  signals.metrics = {{"normal_force_touchdown", 2, "N"},
                     {"normal_force_slide", 2.5 + 1e-5, "N"},
                     {"tangential_force_slide", 0.7, "N"}};
  return signals;
}

std::vector<double> column(const ImposedErrors& errors, const std::string& name) {
  return std::ranges::find(errors.signals, name, &readout::Signal::name)->values;
}

TEST(ImposedQuantities, AGivenForceIsOffByWhatItsSolverLeaves) {
  const ImposedErrors errors = imposed_errors(pressed_case(), pressed_signals());
  const auto force = column(errors, "normal_force");
  EXPECT_DOUBLE_EQ(force[2], 2 * mechanics::contact_tolerance);
  EXPECT_NEAR(force[3], 1e-5, 1e-12);
  EXPECT_DOUBLE_EQ(force[4], 3 * mechanics::contact_tolerance);
  ASSERT_EQ(errors.metrics.size(), 2u); // what rubs is not given
  EXPECT_DOUBLE_EQ(errors.metrics[0].value, 2 * mechanics::contact_tolerance);
  EXPECT_EQ(errors.metrics[1].name, "normal_force_slide");
  EXPECT_NEAR(errors.metrics[1].value, 1e-5, 1e-12);
}

TEST(ImposedQuantities, FrictionOfAContactThatSlipsIsGivenWithTheForce) {
  Case input = pressed_case();
  input.contact.friction = 0.3;
  Signals signals = pressed_signals();
  signals.resolved.columns.back().values.assign(7, 0.0); // the share that sticks
  signals.metrics[2].value = 0.3 * signals.metrics[1].value;
  const auto given = [&] {
    const ImposedErrors errors = imposed_errors(input, signals);
    return std::ranges::find(errors.metrics, "tangential_force_slide", &readout::Metric::name) !=
           errors.metrics.end();
  };
  EXPECT_TRUE(given());
  EXPECT_NEAR(imposed_errors(input, signals).metrics.back().value, 0.3e-5, 1e-12);
  signals.resolved.columns.back().values.assign(7, 0.1);
  EXPECT_FALSE(given());
  signals.resolved.columns.back().values.assign(7, 0.0);
  signals.metrics[2].value *= 1.001;
  EXPECT_FALSE(given());
  signals.metrics[2].value /= 1.001;
  input.contact.law = "saturating";
  input.contact.parameters = {{"strength", 4e6}, {"sharpness", 2}};
  EXPECT_FALSE(given());
}

TEST(ImposedQuantities, OnTheWayToAForceAndOffTheSkinNoForceIsGiven) {
  const ImposedErrors errors = imposed_errors(pressed_case(), pressed_signals());
  for (const std::size_t row : {0u, 1u, 5u, 6u}) {
    EXPECT_TRUE(std::isnan(column(errors, "normal_force")[row])) << row;
  }
  Signals detached = pressed_signals();
  detached.resolved.columns[1].values.assign(7, 0.0);
  detached.metrics[0].value = 0;
  const ImposedErrors none = imposed_errors(pressed_case(), detached);
  EXPECT_TRUE(std::ranges::all_of(column(none, "normal_force"),
                                  [](double value) { return std::isnan(value); }));
  EXPECT_EQ(none.metrics.size(), 1u);
}

TEST(ImposedQuantities, APullThatMayEndIsNotGiven) {
  Case input = pressed_case();
  input.motion.waypoints[2].force = -1.0;
  Signals signals = pressed_signals();
  signals.resolved.columns[1].values = {0, 0.7, 2, 0.5, -1, -0.4, 0};
  const auto force = column(imposed_errors(input, signals), "normal_force");
  EXPECT_FALSE(std::isnan(force[3]));
  EXPECT_TRUE(std::isnan(force[4]));
}

TEST(ImposedQuantities, HeightsAreGivenWhereTheMotionGoesByHeight) {
  Case input = pressed_case();
  const auto force_controlled = column(imposed_errors(input, pressed_signals()), "slider_z");
  EXPECT_EQ(force_controlled[0], 0);
  EXPECT_TRUE(std::isnan(force_controlled[3]));
  for (const std::size_t i : {1u, 2u}) {
    input.motion.waypoints[i].force.reset();
    input.motion.waypoints[i].height = -1e-6 * static_cast<double>(i);
  }
  const ImposedErrors errors = imposed_errors(input, pressed_signals());
  EXPECT_NEAR(column(errors, "slider_z")[3], 0.3e-6, 1e-15);
  EXPECT_TRUE(std::isnan(column(errors, "normal_force")[3]));
  EXPECT_TRUE(errors.metrics.empty());
}

TEST(ImposedQuantities, ADriveIsLedAlongThePathAndItsSliderIsNot) {
  Case input = pressed_case();
  EXPECT_EQ(column(imposed_errors(input, pressed_signals()), "slider_x"),
            std::vector<double>(7, 0.0));
  input.motion.drive.stiffness = 1e3;
  Signals signals = pressed_signals();
  signals.resolved.columns.push_back({"drive_x", "m", signals.resolved.columns[3].values});
  signals.resolved.columns.push_back({"drive_y", "m", signals.resolved.columns[4].values});
  const ImposedErrors errors = imposed_errors(input, signals);
  EXPECT_EQ(column(errors, "drive_x"), std::vector<double>(7, 0.0));
  EXPECT_EQ(std::ranges::find(errors.signals, "slider_x", &readout::Signal::name),
            errors.signals.end());
}

TEST(ImposedQuantities, AGivenStrainHasNone) {
  Case input = pressed_case();
  input.strain.kind = StrainSourceKind::prescribed;
  EXPECT_TRUE(imposed_errors(input, pressed_signals()).signals.empty());
}

} // namespace
} // namespace ionskin::study
