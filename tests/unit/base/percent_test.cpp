// SPDX-License-Identifier: Apache-2.0
#include "ionskin/base/percent.hpp"

#include <gtest/gtest.h>

namespace ionskin::base {
namespace {

TEST(Percent, HasTwoDigitsAndNoExponentBelowAThousand) {
  EXPECT_EQ(percent(0), "0 %");
  EXPECT_EQ(percent(2.1e-6), "0.00021 %");
  EXPECT_EQ(percent(0.0065), "0.65 %");
  EXPECT_EQ(percent(0.0994), "9.9 %");
  EXPECT_EQ(percent(0.28), "28 %");
  EXPECT_EQ(percent(1.004), "100 %");
  EXPECT_EQ(percent(8.84), "880 %");
  EXPECT_EQ(percent(6158.86), "over 1000 %");
}

} // namespace
} // namespace ionskin::base
