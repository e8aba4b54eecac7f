// SPDX-License-Identifier: Apache-2.0
#include "ionskin/live/touches/random_touches.hpp"
#include "ionskin/live/training/stated_errors.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace ionskin::live {
namespace {

const TouchRange range{{{4e-3, 1e-3}, {10e-3, 1.5e-3}}, false, 1e-6, 3e-3};

/// Height or place between the rows of a path [m].
template <class Of> double between(const Motion& motion, double time, Of&& of) {
  const auto next =
      std::ranges::find_if(motion.waypoints, [&](const Waypoint& row) { return row.time >= time; });
  if (next == motion.waypoints.begin()) {
    return of(*next);
  }
  const Waypoint &from = *(next - 1), &to = *next;
  return of(from) + (time - from.time) / (to.time - from.time) * (of(to) - of(from));
}

TEST(RandomTouches, TurnAtWholeMillisecondsWithinTheirRange) {
  const Motion motion = random_touches(range, 30, 7);
  EXPECT_EQ(landings(motion).size(), 30u);
  for (std::size_t i = 0; i < motion.waypoints.size(); ++i) {
    const Waypoint& row = motion.waypoints[i];
    EXPECT_NEAR(std::round(1e3 * row.time), 1e3 * row.time, 1e-9);
    for (const std::size_t d : {0u, 1u}) {
      EXPECT_GE(row.position[d], range.box.low[d]);
      EXPECT_LE(row.position[d], range.box.high[d]);
    }
    EXPECT_GE(*row.height, -range.heaviest);
    if (i > 0 && *row.height < 0 && *motion.waypoints[i - 1].height < 0) {
      const Waypoint& from = motion.waypoints[i - 1];
      const double way =
          std::hypot(row.position[0] - from.position[0], row.position[1] - from.position[1]);
      EXPECT_LE(way, range.fastest * (row.time - from.time) * (1 + 1e-9));
    }
  }
  EXPECT_EQ(random_touches(range, 30, 7).waypoints.back().time, motion.waypoints.back().time);
  EXPECT_NE(random_touches(range, 30, 8).waypoints.back().time, motion.waypoints.back().time);
}

TEST(RandomTouches, RowsBehindCornersLieOnThePath) {
  const Motion motion = random_touches(range, 10, 3), dense = with_rows_behind_corners(motion);
  EXPECT_GT(dense.waypoints.size(), 2 * motion.waypoints.size());
  EXPECT_EQ(landings(dense), landings(motion));
  double before = -1;
  for (const Waypoint& row : dense.waypoints) {
    EXPECT_GT(row.time, before + 0.9e-3);
    before = row.time;
    const auto height = [](const Waypoint& at) { return *at.height; };
    const auto x = [](const Waypoint& at) { return at.position[0]; };
    EXPECT_NEAR(*row.height, between(motion, row.time, height), 1e-12);
    EXPECT_NEAR(row.position[0], between(motion, row.time, x), 1e-12);
  }
}

/// True of a row in contact; the rows are those of heights.
bool presses(const Waypoint& row) {
  return *row.height < 0;
}

TEST(RandomTouches, EachStrokesAndRestsAndSomeTurnBack) {
  const Motion motion = random_touches(range, 60, 11);
  const auto& rows = motion.waypoints;
  std::size_t touches = 0, strokes = 0, rests = 0, reversals = 0;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    if (!presses(rows[i])) {
      if (presses(rows[i - 1]) && touches++ > 0) { // the first one is another
        EXPECT_GT(strokes, 0u) << "touch " << touches;
        EXPECT_GT(rests, 0u) << "touch " << touches;
      }
      strokes = rests = 0;
      continue;
    }
    if (!presses(rows[i - 1])) {
      continue;
    }
    const auto way = [&](std::size_t to, std::size_t d) {
      return rows[to].position[d] - rows[to - 1].position[d];
    };
    const double length = std::hypot(way(i, 0), way(i, 1)),
                 before = std::hypot(way(i - 1, 0), way(i - 1, 1));
    strokes += length > 0;
    rests += length == 0 && rows[i].time - rows[i - 1].time > 0.099;
    const double cosine =
        (way(i, 0) * way(i - 1, 0) + way(i, 1) * way(i - 1, 1)) / (length * before);
    reversals += length > 0 && before > 0 && cosine < -0.9999;
  }
  EXPECT_EQ(touches, 60u);
  EXPECT_GE(reversals, 10u);
}

TEST(RandomTouches, StepTheLoadInARestAndLandInAMillisecondAsInATenth) {
  const Motion motion = random_touches(range, 60, 11);
  const auto& rows = motion.waypoints;
  std::size_t touches = 0, steps = 0;
  double fastest_step = 1, slowest_step = 0, fastest_landing = 1, slowest_landing = 0;
  for (std::size_t i = 2; i + 1 < rows.size(); ++i) {
    const double duration = rows[i].time - rows[i - 1].time;
    const auto rests = [&](std::size_t to) {
      return presses(rows[to - 1]) && presses(rows[to]) &&
             rows[to].position == rows[to - 1].position;
    };
    if (presses(rows[i]) && !presses(rows[i - 1])) {
      ++touches;
      fastest_landing = std::min(fastest_landing, duration);
      slowest_landing = std::max(slowest_landing, duration);
    }
    if (rests(i - 1) && rests(i) && rests(i + 1) && *rows[i].height != *rows[i - 1].height) {
      EXPECT_EQ(*rows[i + 1].height, *rows[i].height);
      fastest_step = std::min(fastest_step, duration);
      slowest_step = std::max(slowest_step, duration);
      ++steps;
    }
  }
  EXPECT_EQ(touches, 59u); // the first begins before row 2
  EXPECT_EQ(steps, 59u);
  EXPECT_LT(fastest_step, 2.5e-3);
  EXPECT_NEAR(slowest_step, 10e-3, 2e-3);
  EXPECT_LT(fastest_landing, 3.5e-3);
  EXPECT_NEAR(slowest_landing, 0.1, 0.02);
}

TEST(RandomTouches, OneAloneWaitsStrokesRestsAndWaits) {
  const TouchRange pressed{range.box, true, 2, range.fastest};
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const auto rows = random_touch(pressed, seed).waypoints;
    ASSERT_GE(rows.size(), 7u); // landing, stroke, rest with a load step, lift-off, and the waits
    EXPECT_LE(rows.size(), 16u);
    EXPECT_EQ(rows[0].time, 0);
    EXPECT_GE(rows[1].time, 0.2);
    EXPECT_EQ(landings(random_touch(pressed, seed)).size(), 1u);
    for (const std::size_t outside : {std::size_t{0}, std::size_t{1}, rows.size() - 1}) {
      EXPECT_FALSE(rows[outside].force);
      EXPECT_GT(*rows[outside].height, 0);
    }
    for (const Waypoint& row : rows) {
      EXPECT_LE(row.force.value_or(0), pressed.heaviest);
      EXPECT_GE(row.position[0], range.box.low[0]);
      EXPECT_LE(row.position[0], range.box.high[0]);
    }
  }
  EXPECT_EQ(random_touch(pressed, 5).waypoints.back().time,
            random_touch(pressed, 5).waypoints.back().time);
  EXPECT_NE(random_touch(pressed, 5).waypoints[1].position,
            random_touch(pressed, 6).waypoints[1].position);
}

TEST(RandomTouches, BeginAtAnyYawWhereTheUndersideTurns) {
  TouchRange turning = range;
  turning.fastest_turn = 1;
  turning.any_yaw = true;
  const Motion motion = random_touches(turning, 40, 5);
  double turned = 0, lowest = 10, highest = 0, last = -1;
  for (std::size_t i = 1; i < motion.waypoints.size(); ++i) {
    const Waypoint &from = motion.waypoints[i - 1], &to = motion.waypoints[i];
    if (*from.height < 0 && *to.height < 0) {
      const double turn = std::abs(*to.yaw - *from.yaw), lasts = to.time - from.time;
      turned += to.time < landings(motion)[1] ? turn : 0;
      EXPECT_TRUE(to.time < landings(motion)[1] || turn <= lasts * (1 + 1e-9));
    } else if (*from.height > 0 && *to.height < 0) { // a landing, at the yaw of the wait before
      EXPECT_EQ(*to.yaw, *from.yaw);
      EXPECT_NE(*to.yaw, last);
      last = *to.yaw;
      lowest = std::min(lowest, *to.yaw);
      highest = std::max(highest, *to.yaw);
    }
  }
  EXPECT_NEAR(turned, 2 * std::numbers::pi, 1e-9) << "the first touch goes through all of them";
  EXPECT_LT(lowest, 1);
  EXPECT_GT(highest, 5);
}

TEST(StatedErrors, AreAQuarterMoreThanTheLargestOfAnyTouch) {
  const auto stated = stated_errors({{"charge_top", "hold", 5, {0.1, 0.3, 0.2}, {1, 2, 4}}});
  ASSERT_EQ(stated.size(), 1u);
  EXPECT_EQ(stated[0].name, "charge_top");
  EXPECT_EQ(stated[0].event, "hold");
  EXPECT_DOUBLE_EQ(stated[0].rms, 0.375);
  EXPECT_EQ(stated[0].worst, 5);
  EXPECT_EQ(stated[0].largest, 5);
  EXPECT_LT(std::pow(0.95, validation_touches), 0.01);
}

} // namespace
} // namespace ionskin::live
