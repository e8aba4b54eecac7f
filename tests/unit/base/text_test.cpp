// SPDX-License-Identifier: Apache-2.0
#include "ionskin/base/text.hpp"

#include <gtest/gtest.h>

namespace ionskin::base {
namespace {

using Parts = std::vector<std::string>;

TEST(Text, TrimmedLosesBlanksAtItsEndsAlone) {
  EXPECT_EQ(trimmed(" \t3 mm\t"), "3 mm");
  EXPECT_EQ(trimmed("3 mm\r"), "3 mm\r");
  EXPECT_EQ(trimmed(" \t "), "");
  EXPECT_EQ(trimmed(""), "");
}

TEST(Text, SplitKeepsEmptyParts) {
  EXPECT_EQ(split("a, b\t,c d", ','), (Parts{"a", "b", "c d"}));
  EXPECT_EQ(split(",a,", ','), (Parts{"", "a", ""}));
  EXPECT_EQ(split("", ','), Parts{""});
}

TEST(Text, ShownIsOneLineThatNoTerminalActsOn) {
  EXPECT_EQ(shown("a\x1b[31mb\nc\x7f"), "a\\x1b[31mb\\nc\\x7f");
  EXPECT_EQ(shown(std::string("a\0b", 3)), "a\\x00b");
  EXPECT_EQ(shown("\xff\xc3"), "\\xff\\xc3");
  EXPECT_EQ(shown("\xc2\x9b\xe2\x80\xae"), "\\xc2\\x9b\\xe2\\x80\\xae"); // C1, right to left
  EXPECT_EQ(shown("√Hz µm"), "√Hz µm");
}

TEST(Text, ShownIsShort) {
  EXPECT_LT(shown(std::string(50'000, 'x')).size(), 160u);
  EXPECT_LT(shown(std::string(50'000, '\x1b')).size(), 160u);
  EXPECT_LT(printable(std::string(50'000, 'x')).size(), 500u);
  EXPECT_LT(printable(std::string(50'000, '\n')).size(), 500u);
}

TEST(Text, PrintableKeepsLinesAndTabs) {
  EXPECT_EQ(printable("a\n\tb\r"), "a\n\tb\\x0d");
}

TEST(Text, CsvCellsAreNoFormulas) {
  EXPECT_EQ(csv_cell("=1+1"), "\"'=1+1\"");
  EXPECT_EQ(csv_cell("@SUM(A1)"), "\"'@SUM(A1)\"");
  EXPECT_EQ(csv_cell("-1+2"), "\"'-1+2\"");
  EXPECT_EQ(csv_cell("-1.5e-3"), "-1.5e-3");
  EXPECT_EQ(csv_cell("a \"b\", c"), "\"a \"\"b\"\", c\"");
  EXPECT_EQ(csv_cell("coulomb"), "coulomb");
}

} // namespace
} // namespace ionskin::base
