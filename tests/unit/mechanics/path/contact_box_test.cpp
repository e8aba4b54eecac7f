// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/path/contact_box.hpp"

#include <gtest/gtest.h>

namespace ionskin::mechanics {
namespace {

/// A path that presses, then pulls while it moves across the skin, and lifts off.
Case pulled_across(const std::string& law) {
  Case input;
  input.contact.law = law;
  input.motion.kind = MotionKind::waypoints;
  input.motion.waypoints = {{0, {5e-3, 1e-3}, 1e-4, {}}, {1, {5e-3, 1e-3}, {}, 1.0},
                            {2, {5e-3, 1e-3}, {}, -0.1}, {3, {5e-3, 2e-3}, {}, -0.1},
                            {4, {5e-3, 2e-3}, 1e-4, {}}, {5, {9e-3, 4e-3}, 1e-4, {}}};
  return input;
}

TEST(ContactBox, HoldsThePositionsAtWhichAdhesionHoldsTheSlider) {
  const auto box = contact_box(pulled_across("adhesive"));
  ASSERT_TRUE(box);
  EXPECT_EQ(box->low, (std::array{5e-3, 1e-3}));
  EXPECT_EQ(box->high, (std::array{5e-3, 2e-3}));
}

TEST(ContactBox, EndsWhereASliderWithoutAdhesionLeaves) {
  const auto box = contact_box(pulled_across("coulomb"));
  ASSERT_TRUE(box);
  EXPECT_EQ(box->high, (std::array{5e-3, 1e-3}));
}

} // namespace
} // namespace ionskin::mechanics
