// SPDX-License-Identifier: Apache-2.0
#include "ionskin/handover/cell_slip.hpp"

#include "synthetic_contact.hpp"

#include <gtest/gtest.h>

namespace ionskin::handover {
namespace {

/// Two cells under a slider that moves by 6 mm: the skin follows by 0.4 um at the first, by nothing
/// at the second, which loses touch when lift-off begins.
mechanics::ContactSolution two_cells(const Case& input) {
  mechanics::ContactSolution contact = synthetic_contact(input);
  contact.cell_lines_x = {-1e-3, 0, 1e-3};
  contact.cell_lines_y = {-0.5e-3, 0.5e-3};
  const auto give = [](const mechanics::SharedState& shared, double surface_x, double second) {
    if (shared) {
      auto& state = const_cast<mechanics::ContactState&>(*shared);
      const double pressure = state.indentation > 0 ? 1e6 : 0;
      state.normal_traction = {pressure, second * pressure};
      state.tangential_traction_x = state.tangential_traction_y = {0, 0};
      state.surface = {0, pressure > 0 ? surface_x : 0, 0, 0, 0, 0};
    }
  };
  for (const auto& instant : contact.stepped) {
    const double since_set_off = instant.time - 0.5;
    const double surface = since_set_off <= 0 ? 0 : since_set_off <= 0.5e-3 ? 0.3e-6 : 0.4e-6;
    give(instant.state, surface, instant.time > 2.5 ? 0 : 1);
  }
  return contact;
}

TEST(CellSlip, IsTheWayOverEachCellSinceItTouches) {
  const Case input = small_case();
  const mechanics::ContactSolution contact = two_cells(input);
  const ContactTimeline timeline(input, contact);
  const double speed = input.motion.stroke / input.motion.slide;
  const double first = 0.5 + 1e-6 / speed, lifting = 2.5 + 0.25 / 1001;
  const auto slip = slip_since_landing(timeline, contact, {lifting, 0.5, first, 2.5, 3.5});
  ASSERT_EQ(slip.size(), 5u);
  EXPECT_EQ(slip[1], (std::vector<double>{0, 0}));
  EXPECT_NEAR(slip[2][0], 0.7e-6, 1e-15);
  EXPECT_NEAR(slip[2][1], 1e-6, 1e-15);
  EXPECT_NEAR(slip[3][0], 6e-3 - 0.4e-6, 1e-12);
  EXPECT_NEAR(slip[3][1], 6e-3, 1e-12);
  EXPECT_GT(slip[0][0], 5.9e-3);
  EXPECT_EQ(slip[0][1], 0);
  EXPECT_EQ(slip[4], (std::vector<double>{0, 0}));
}

} // namespace
} // namespace ionskin::handover
