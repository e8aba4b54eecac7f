// SPDX-License-Identifier: Apache-2.0
#include "ionskin/base/value_at.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace ionskin::base {
namespace {

TEST(ValueAt, ARowIgnoresItsEmptyNeighbours) {
  EXPECT_EQ(value_at({0, 1, 2}, {NAN, 4, NAN}, 1.0), 4);
  EXPECT_TRUE(std::isnan(value_at({0, 1, 2}, {NAN, 4, NAN}, 1.5)));
  EXPECT_EQ(value_at({0, 1}, {2, 4}, 0.25), 2.5);
  EXPECT_EQ(value_at({0, 1}, {2, 4}, -1), 2);
  EXPECT_EQ(value_at({0, 1}, {2, 4}, 9), 4);
}

} // namespace
} // namespace ionskin::base
