// SPDX-License-Identifier: Apache-2.0
#include "ionskin/handover/contact_signals.hpp"

#include "synthetic_contact.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace ionskin::handover {
namespace {

/// One cell of 2 mm2 that a slider drags along by 0.4 um before it slips, on a slide of 6 mm.
mechanics::ContactSolution dragged_cell(const Case& input) {
  mechanics::ContactSolution contact = synthetic_contact(input);
  contact.cell_lines_x = {-1e-3, 1e-3};
  contact.cell_lines_y = {-0.5e-3, 0.5e-3};
  const auto give = [](const mechanics::SharedState& shared, double surface_x, double stick) {
    if (shared) {
      auto& state = const_cast<mechanics::ContactState&>(*shared);
      const bool loaded = state.indentation > 0;
      state.normal_traction = {loaded ? 1e6 : 0.0};
      state.tangential_traction_x = state.tangential_traction_y = {0};
      state.surface = {loaded ? 1e-6 : 0.0, loaded ? surface_x : 0.0, 0};
      state.contact_area = loaded ? 2e-6 : 0;
      state.stick_area = loaded ? 2e-6 * stick : 0;
    }
  };
  for (const auto& instant : contact.stepped) {
    give(instant.state, 0.4e-6, 0);
  }
  const auto& instants = contact.stepped; // detached, landing, pressed, two of the onset
  give(instants[2].state, 0, 1);
  give(instants[3].state, 0.3e-6, 0.25);
  give(instants[4].state, 0.4e-6, 0);
  return contact;
}

TEST(ContactSignals, TellAreaStickAndSlipSinceLanding) {
  const Case input = small_case();
  const mechanics::ContactSolution contact = dragged_cell(input);
  const ContactTimeline timeline(input, contact);
  const ContactSignals signals = contact_signals(timeline, contact);
  const std::vector<double>& time = timeline.sample_times();
  ASSERT_EQ(signals.slip.size(), time.size());
  const double speed = input.motion.stroke / input.motion.slide;
  const auto row = [&](double instant) {
    return std::lower_bound(time.begin(), time.end(), instant - 1e-12) - time.begin();
  };
  const auto pressed = row(0.5), first = row(0.5 + 1e-6 / speed), end = row(2.5);
  EXPECT_EQ(signals.area[0], 0);
  EXPECT_NEAR(signals.area[pressed], 2e-6, 1e-18);
  EXPECT_EQ(signals.stick_share[pressed], 1);
  EXPECT_EQ(signals.slip[pressed], 0);
  EXPECT_NEAR(signals.stick_share[first], 0.25, 1e-12);
  EXPECT_NEAR(signals.slip[first], 0.7e-6, 1e-15);
  EXPECT_EQ(signals.stick_share[end], 0);
  EXPECT_NEAR(signals.slip[end], 6e-3 - 0.4e-6, 1e-12);
  EXPECT_EQ(signals.area.back(), 0);
  EXPECT_EQ(signals.stick_share.back(), 0);
  EXPECT_EQ(signals.slip.back(), 0);
}

} // namespace
} // namespace ionskin::handover
