// SPDX-License-Identifier: Apache-2.0
#include "ionskin/electrochemistry/time/step_landings.hpp"

#include "model_cases.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace ionskin::electrochemistry {
namespace {

TEST(StepLandings, AreSamplesAndWantedInstantsInOrder) {
  auto history = verification::sliding_contact_history(2);
  history.event_time = {0.5, 3.0};
  history.time.insert(history.time.begin() + 1, 0.25);
  const auto landings = make_step_landings(history, {7.0, 1.2345});
  EXPECT_TRUE(std::is_sorted(landings.time.begin(), landings.time.end()));
  EXPECT_EQ(landings.time.size(), history.time.size() + 2);
  for (std::size_t i = 0; i < landings.time.size(); ++i) {
    EXPECT_EQ(landings.is_event[i], landings.time[i] == 0.5) << landings.time[i];
    EXPECT_EQ(landings.is_field[i], landings.time[i] == 7.0 || landings.time[i] == 1.2345)
        << landings.time[i];
  }
}

TEST(StepLandings, WantedInstantsNextToASampleOrOutsideAddNone) {
  const auto history = verification::linear_step_history(0.0, 1.0, {0.0, 1.0});
  const auto landings = make_step_landings(history, {5.0, 1.0 + 1e-14});
  EXPECT_EQ(landings.time, history.time);
  EXPECT_EQ(landings.is_field, (std::vector{false, true}));
}

TEST(StepLandings, FindsTheNextOne) {
  const StepLandings landings{{0.0, 1.0, 2.0}, {true, false, false}, {false, false, false}};
  EXPECT_EQ(landings.behind(0.0), 1U);
  EXPECT_EQ(landings.behind(0.5), 1U);
  EXPECT_EQ(landings.behind(1.0), 2U);
}

} // namespace
} // namespace ionskin::electrochemistry
