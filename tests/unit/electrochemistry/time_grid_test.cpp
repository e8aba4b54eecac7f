// SPDX-License-Identifier: Apache-2.0
#include "ionskin/electrochemistry/time_grid.hpp"

#include "model_cases.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace ionskin::electrochemistry {
namespace {

bool lands_on(const std::vector<double>& grid, double instant) {
  return std::find(grid.begin(), grid.end(), instant) != grid.end();
}

const StepRule rule{1e-5, 1.5, 0.05};

TEST(TimeGrid, LandsOnEverySampleEventAndWantedInstant) {
  auto history = verification::sliding_contact_history(2);
  const auto grid = make_time_grid(history, rule, {1.2345, 7.0});
  for (const double sample : history.time) {
    EXPECT_TRUE(lands_on(grid, sample)) << sample;
  }
  EXPECT_TRUE(lands_on(grid, 1.2345));
  EXPECT_TRUE(lands_on(grid, 7.0));
  EXPECT_TRUE(std::is_sorted(grid.begin(), grid.end()));
  EXPECT_EQ(grid.back(), history.time.back());
}

TEST(TimeGrid, RestartsAtEventsOnlyAndKeepsTheRule) {
  auto history = verification::linear_step_history(0.0, 1.0, {0.0, 0.3, 1.0, 2.0});
  history.event_time = {0.0, 1.0};
  const auto grid = make_time_grid(history, rule, {});
  for (std::size_t i = 1; i < grid.size(); ++i) {
    const double step = grid[i] - grid[i - 1];
    EXPECT_LE(step, rule.longest * 1.001);
    EXPECT_GT(step, 0.4 * rule.first);
    if (grid[i - 1] == 0.0 || grid[i - 1] == 1.0) {
      EXPECT_NEAR(step, rule.first, 1e-12);
    } else if (grid[i - 1] == 0.3) {
      EXPECT_GT(step, 0.02);
    }
  }
}

TEST(TimeGrid, WantedInstantsOutsideTheHistoryMoveToItsEnds) {
  const auto history = verification::linear_step_history(0.0, 1.0, {0.0, 1.0});
  EXPECT_EQ(make_time_grid(history, rule, {5.0, 1.0 + 1e-14}), make_time_grid(history, rule, {}));
}

TEST(StepRule, RefinementDividesEveryStep) {
  const DerivedScales scales = derive_scales(verification::model_case().electrochemistry, 180e-6);
  const StepRule once = step_rule({Preset::standard, 1.0, 1.0}, scales);
  const StepRule twice = step_rule({Preset::standard, 1.0, 2.0}, scales);
  EXPECT_DOUBLE_EQ(once.first, 1e-5);
  EXPECT_DOUBLE_EQ(once.longest, 0.05);
  EXPECT_DOUBLE_EQ(twice.first, 0.5 * once.first);
  EXPECT_DOUBLE_EQ(twice.longest, 0.5 * once.longest);
  EXPECT_DOUBLE_EQ(twice.growth - 1.0, 0.5 * (once.growth - 1.0));
  const auto history = verification::sliding_contact_history(1);
  const double ratio = static_cast<double>(make_time_grid(history, twice, {}).size()) /
                       static_cast<double>(make_time_grid(history, once, {}).size());
  EXPECT_NEAR(ratio, 2.0, 0.2);
}

} // namespace
} // namespace ionskin::electrochemistry
