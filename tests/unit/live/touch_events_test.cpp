// SPDX-License-Identifier: Apache-2.0
#include "ionskin/live/errors/shortfall.hpp"
#include "ionskin/live/training/touch_events.hpp"
#include "small_skin.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <vector>

namespace ionskin::live {
namespace {

constexpr double event_speed = 2e-6; // [m] in an instant

/// A path made of pieces, an instant each millisecond.
struct EventPath {
  std::vector<TouchInstant> instants{TouchInstant{}};

  void piece(std::size_t number, bool touches, double way_x, double way_y, bool sticks,
             double load_change = 0) {
    for (std::size_t i = 0; i < number; ++i) {
      TouchInstant next = instants.back();
      next.centre[0] += way_x;
      next.centre[1] += way_y;
      next.load = touches ? (next.touches ? next.load : 1) + load_change : 0;
      next.touches = touches;
      next.sticks = touches && sticks;
      instants.push_back(next);
    }
  }
  /// First and last instant of an event between two instants; their number as well.
  std::vector<std::size_t> of(std::size_t event) const {
    std::vector<std::size_t> where;
    const auto events = events_of(instants);
    for (std::size_t i = 0; i < events.size(); ++i) {
      if ((events[i] >> event & 1u) != 0) {
        where.push_back(i);
      }
    }
    return where;
  }
};

std::vector<std::size_t> instants_from(std::size_t first, std::size_t last) {
  std::vector<std::size_t> where;
  for (std::size_t i = first; i < last; ++i) {
    where.push_back(i);
  }
  return where;
}

TEST(TouchEvents, OfLandingHoldAndLift) {
  EventPath path;
  path.piece(99, false, 0, 0, false);
  path.piece(200, true, 0, 0, true);
  path.piece(200, false, 0, 0, false);
  EXPECT_EQ(path.of(event::landing), instants_from(100, 150));
  // It rests from instant 101 on, the first that is like the one before.
  EXPECT_EQ(path.of(event::hold), instants_from(151, 300));
  EXPECT_EQ(path.of(event::lift), instants_from(250, 350));
  EXPECT_EQ(path.of(event::slip_onset), std::vector<std::size_t>{});
}

TEST(TouchEvents, AnOnsetLastsWhileSomethingSticksAndALengthAtLeast) {
  EventPath path;
  path.piece(200, true, 0, 0, true);
  path.piece(80, true, event_speed, 0, true);
  path.piece(100, true, event_speed, 0, false);
  path.piece(10, true, -event_speed, 0, true); // back
  path.piece(100, true, -event_speed, 0, false);
  path.piece(100, true, 0, -event_speed, false); // a right angle is no turn back
  std::vector<std::size_t> expected = instants_from(201, 281);
  const std::vector<std::size_t> back = instants_from(381, 431);
  expected.insert(expected.end(), back.begin(), back.end());
  EXPECT_EQ(path.of(event::slip_onset), expected);
}

TEST(TouchEvents, ChangesOfLoadAreNoHold) {
  EventPath path;
  path.piece(100, true, 0, 0, true, 1e-3);
  EXPECT_EQ(path.of(event::hold), std::vector<std::size_t>{});
  EXPECT_EQ(path.of(event::load_step), std::vector<std::size_t>{});
}

TEST(TouchEvents, ALoadStepLastsALengthAndIsNeitherLandingNorLift) {
  EventPath path;
  path.piece(40, true, 0, 0, true, 0.05); // to a load of 3 within the landing
  path.piece(60, true, 0, 0, true);
  path.piece(4, true, 0, 0, true, -0.5);
  path.piece(100, true, 0, 0, true);
  path.piece(10, true, 0, 0, true, 0.2);
  path.piece(30, true, 0, 0, true);
  path.piece(100, false, 0, 0, false);
  EXPECT_EQ(path.of(event::load_step), instants_from(101, 154));
  EXPECT_EQ(path.of(event::lift), instants_from(195, 295)); // with the second change of load
}

TEST(Shortfall, NamesEventsAboveThePromiseAlone) {
  SkinData data = small_skin();
  data.errors = {{"charge_top", "", 5, 5, 10}, // of whole touches
                 {"charge_top", "hold", 0.9, 2, 10},
                 {"normal_force", "lift", 0, 0, 0}};
  EXPECT_EQ(shortfall(data), "");
  data.errors.push_back({"charge_top", "landing", 1.2, 2, 10});
  data.errors.push_back({"current_top", "slip_onset", 3, 5, 10});
  EXPECT_EQ(shortfall(data),
            "rms errors above the promised 10 % of the largest value within an event: "
            "current_top in slip_onset 30 %, charge_top in landing 12 %");
  for (const char* name : {"a", "b", "c"}) {
    data.errors.push_back({name, "lift", 1.1, 2, 10});
  }
  EXPECT_NE(shortfall(data).find(", a in lift 11 %, b in lift 11 %, and 1 more"),
            std::string::npos);
}

} // namespace
} // namespace ionskin::live
