// SPDX-License-Identifier: Apache-2.0
#include "ionskin/base/text.hpp"

#include <gtest/gtest.h>

namespace ionskin::base {
namespace {

using Parts = std::vector<std::string>;

TEST(Text, TrimmedLosesBlanksAtItsEndsAlone) {
  EXPECT_EQ(trimmed(" \t3 mm\t"), "3 mm");
  EXPECT_EQ(trimmed("3 mm\r"), "3 mm\r");
  EXPECT_EQ(trimmed("\"3 mm\" \r", csv_blanks), "3 mm");
  EXPECT_EQ(trimmed(" \t "), "");
  EXPECT_EQ(trimmed(""), "");
}

TEST(Text, SplitKeepsEmptyParts) {
  EXPECT_EQ(split("a, b\t,c d", ','), (Parts{"a", "b", "c d"}));
  EXPECT_EQ(split(",a,", ','), (Parts{"", "a", ""}));
  EXPECT_EQ(split("", ','), Parts{""});
  EXPECT_EQ(split("\"a\",1\r", ',', csv_blanks), (Parts{"a", "1"}));
}

} // namespace
} // namespace ionskin::base
