// SPDX-License-Identifier: Apache-2.0
#include "ionskin/base/largest.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace ionskin::base {
namespace {

TEST(Larger, KeepsNaNOnEitherSide) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(nan_max(1, 2), 2);
  EXPECT_EQ(nan_max(2, 1), 2);
  EXPECT_TRUE(std::isnan(nan_max(nan, 1)));
  EXPECT_TRUE(std::isnan(nan_max(1, nan)));
  EXPECT_TRUE(std::isnan(nan_max(nan_max(nan, 1), 5)));
}

TEST(LargestMagnitude, IsOfEitherSignAndKeepsNaN) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(largest_magnitude(std::vector<double>{1, -3, 2}), 3);
  EXPECT_EQ(largest_magnitude({}), 0);
  EXPECT_TRUE(std::isnan(largest_magnitude(std::vector<double>{nan, 1})));
}

} // namespace
} // namespace ionskin::base
