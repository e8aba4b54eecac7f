// SPDX-License-Identifier: Apache-2.0
#include "ionskin/electrochemistry/time/step_control.hpp"

#include "model_cases.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace ionskin::electrochemistry {
namespace {

const StepControl control{{{0.0, 1.0, 3.0}, {true, true, false}, {true, false, true}},
                          {1e-4, 1e-5, 0.5, 0, 1e-12, 4.0, 1e-3}};
const double rounded_by = std::exp2(1 / 64.0) - 1; ///< of the factors on a length

TEST(StepControl, LandsWithoutSlivers) {
  EXPECT_DOUBLE_EQ(control.step_end(0.2, 0.1), 0.3);
  EXPECT_EQ(control.step_end(0.9, 0.2), 1.0);
  EXPECT_DOUBLE_EQ(control.step_end(0.85, 0.1), 0.925);
  EXPECT_EQ(control.step_end(1.0, 9.0), 1.5);
  EXPECT_TRUE(control.finished(3.0));
  EXPECT_FALSE(control.finished(2.9));
}

TEST(StepControl, StretchesAStepFromLandingToLanding) {
  const StepControl regular{{{0.0, 1.0, 2.0}, {false, false, false}, {false, false, false}},
                            {1e-4, 1e-5, 1.0, 0, 1e-12, 4.0, 1e-3}};
  EXPECT_EQ(regular.step_end(1.0, 0.95), 2.0);
  EXPECT_DOUBLE_EQ(regular.step_end(1.0, 0.85), 1.5);
  EXPECT_DOUBLE_EQ(regular.step_end(1.05, 0.9), 1.525);
}

TEST(StepControl, ErrorOfThirdOrderSetsTheLength) {
  for (const double error : {0.02, 0.1, 0.4, 0.9}) {
    const double ideal = 0.1 * 0.85 / std::cbrt(error);
    EXPECT_NEAR(control.after_success(0.1, 0.2, 0.1, error), ideal, rounded_by * ideal);
  }
  EXPECT_NEAR(control.after_success(0.1, 0.2, 0.1, 0.0), 0.4, 1e-12);
  EXPECT_LT(control.after_rejection(0.1, 0.2, 1.01), 0.071);
  EXPECT_NEAR(control.after_rejection(0.1, 0.2, 1e9), 0.01, 1e-12);
  EXPECT_NEAR(control.after_failure(0.1, 0.2), 0.025, 1e-12);
}

TEST(StepControl, RoundingOfTheErrorDoesNotSetTheLength) {
  for (const double error : {0.02, 0.1, 0.4, 0.9}) {
    EXPECT_EQ(control.after_success(0.1, 0.2, 0.1, error),
              control.after_success(0.1, 0.2, 0.1, error * (1 + 1e-4)));
  }
}

TEST(StepControl, RestartsBehindEventsAndRemembersLongerStepsElsewhere) {
  EXPECT_EQ(control.after_success(0.9, 1.0, 0.5, 0.0), 1e-5);
  EXPECT_EQ(control.after_success(2.99, 3.0, 0.5, 0.1), 0.5);
}

TEST(StepControl, LooksAtColumnsOnTheWayToKeptFields) {
  EXPECT_EQ(control.column_share(0.0), 1e-3);
  EXPECT_GT(control.column_share(1.0), 1e-3);
  EXPECT_GT(control.column_share(2.5), 1e-3);
}

TEST(StepControl, KnowsTheLandingsOfAnEarlierRun) {
  EXPECT_TRUE(control.has_landed({0.0, 0.4, 1.0, 1.7}));
  EXPECT_FALSE(control.has_landed({0.0, 0.4, 1.7}));
  EXPECT_FALSE(control.has_landed({0.1, 1.0}));
}

TEST(StepRule, RefinementDividesStepsOfThirdOrder) {
  const DerivedScales scales = derive_scales(verification::model_case().electrochemistry, 180e-6);
  const StepRule once = step_rule({Preset::standard, 1.0, 1.0}, {}, scales);
  const StepRule twice = step_rule({Preset::standard, 1.0, 2.0}, {}, scales);
  EXPECT_DOUBLE_EQ(once.tolerance, preset_tolerance(Preset::standard));
  EXPECT_DOUBLE_EQ(twice.tolerance, once.tolerance / 8.0);
  EXPECT_DOUBLE_EQ(twice.first, 0.5 * once.first);
  EXPECT_DOUBLE_EQ(twice.longest, 0.5 * once.longest);
  EXPECT_DOUBLE_EQ(twice.growth, std::sqrt(once.growth));
  EXPECT_DOUBLE_EQ(
      step_rule({.preset = Preset::fine, .time_tolerance = 0.01}, {}, scales).tolerance, 0.01);
}

TEST(StepRule, LongestStepScalesWithTheDecay) {
  Electrochemistry ions = verification::model_case().electrochemistry;
  const StepRule rule = step_rule({}, {}, derive_scales(ions, 180e-6));
  EXPECT_EQ(rule.longest, 0.15);
  EXPECT_DOUBLE_EQ(step_rule({}, {}, derive_scales(ions, 18e-6)).longest, 0.015);
  ions.diffusivity /= 100;
  EXPECT_DOUBLE_EQ(step_rule({}, {}, derive_scales(ions, 180e-6)).longest, 15.0);
}

TEST(StepControl, LongAfterAnEventStepsGrowWithTheTimeSince) {
  const StepControl late{{{0.0, 10.0, 1000.0}, {true, true, false}, {false, false, false}},
                         {1e-4, 1e-5, 0.5, 0.05, 1e-12, 4.0, 1e-3}};
  EXPECT_DOUBLE_EQ(late.step_end(15.0, 100.0), 15.5);
  EXPECT_DOUBLE_EQ(late.step_end(110.0, 100.0), 115.0);
  const double ideal = 5.0 * 0.85 / std::cbrt(0.5);
  EXPECT_NEAR(late.after_success(110.0, 115.0, 100.0, 0.5), ideal, rounded_by * ideal);
}

TEST(StepRule, TaxelsAskForSingleColumns) {
  const DerivedScales scales = derive_scales(verification::model_case().electrochemistry, 180e-6);
  Readout readout;
  const StepRule whole = step_rule({}, readout, scales);
  readout.taxels.emplace_back();
  EXPECT_DOUBLE_EQ(step_rule({}, readout, scales).column_share, 10.0 * whole.column_share);
}

TEST(EstimatedSteps, FollowTheToleranceAndTheLandings) {
  const DerivedScales scales = derive_scales(verification::model_case().electrochemistry, 180e-6);
  const StepRule rule = step_rule({Preset::standard, 1.0, 1.0}, {}, scales);
  // The steps on the tail of the baseline are 0.08 s long at first.
  EXPECT_NEAR(relaxation_step(rule, scales), 0.08, 0.005);
  // The steps are 0.054 s long while the slider passes columns of 0.2 mm at 3 mm/s.
  EXPECT_NEAR(crossing_step(rule, 0.2 / 3.0), 0.054, 0.001);
  const StepLandings landings{{0.0, 1.0, 3.0}, {true, true, false}, {false, false, false}};
  const StepRule doubling{1e-4, 0.1, 0.5, 0, 1e-12, 2.0, 1e-3};
  // 0.1, 0.2, 0.4 and 0.5; again 0.1 and 0.2, then seven of 0.25.
  EXPECT_EQ(estimate_steps(landings, doubling, 1.0, {1.0, 0.25}), 4U + 9U);
}

TEST(EstimatedSteps, AreCountedAtOnceHoweverMany) {
  const StepLandings landings{{0.0, 1e7}, {true, true}, {false, false}};
  const StepRule rule{1e-4, 1e-15, 0.5, 0, 1e-12, 2.0, 1e-3};
  EXPECT_GE(estimate_steps(landings, rule, 1.0, {1e-15}), 1'000'000'000'000U);
}

TEST(EstimatedSteps, LengthenWithTheTimeSinceTheEvent) {
  constexpr double endless = std::numeric_limits<double>::infinity();
  const StepLandings landings{{0.0, 1e7}, {true, false}, {false, false}};
  const StepRule rule{1e-4, 0.1, 0.5, 0.05, 1e-12, 2.0, 1e-3};
  // Some 22 steps of 0.5 s in 10 s, then each a twentieth of the time: ln(1e6)/ln(1.05) = 283.
  EXPECT_NEAR(static_cast<double>(estimate_steps(landings, rule, 1.0, {endless})), 22 + 283, 3);
  // The edges of the slider cross columns: a step takes at most 100 s.
  EXPECT_NEAR(static_cast<double>(estimate_steps(landings, rule, 1.0, {100.0})),
              22 + std::log(200) / std::log(1.05) + 1e5 - 20, 5);
  // Far from the beginning of the run, where a step is lost in its time.
  const StepLandings late{{0.0, 1e7, 2e7}, {true, true, false}, {false, false, false}};
  const StepRule short_steps{1e-4, 1e-13, 1e-12, 0.05, 1e-16, 2.0, 1e-3};
  EXPECT_LT(estimate_steps(late, short_steps, 1.0, {endless, endless}), 3000U);
}

} // namespace
} // namespace ionskin::electrochemistry
