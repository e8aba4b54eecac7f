// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/sweep/sweep_axis.hpp"

#include "ionskin/base/error.hpp"
#include "scratch_folder.hpp"

#include <gtest/gtest.h>

namespace ionskin::study {
namespace {

using Texts = std::vector<std::string>;

TEST(SweepAxis, StepsIncludeBothEndsWithoutRounding) {
  const SweepAxis axis = parse_axis("contact.friction=0.05:0.05:0.5");
  EXPECT_EQ(axis.key, "contact.friction");
  EXPECT_EQ(axis.values,
            (Texts{"0.05", "0.1", "0.15", "0.2", "0.25", "0.3", "0.35", "0.4", "0.45", "0.5"}));
  EXPECT_EQ(parse_axis("a=3:-1:1").values, (Texts{"3", "2", "1"}));
  EXPECT_EQ(parse_axis("a=0:0.4:1").values, (Texts{"0", "0.4", "0.8"}));
}

TEST(SweepAxis, OneUnitServesAWholeRange) {
  EXPECT_EQ(parse_axis("motion.stroke=1:0.5:2 mm").values, (Texts{"1 mm", "1.5 mm", "2 mm"}));
  EXPECT_EQ(parse_axis("motion.stroke=\"1 mm\":\"1 mm\":\"2 mm\"").values, (Texts{"1 mm", "2 mm"}));
  EXPECT_NE(results::message_of<UserError>([] { parse_axis("a=1 mm:500 um:3 mm"); }).find("mixes"),
            std::string::npos);
}

TEST(SweepAxis, ListsRespectQuotesAndBrackets) {
  EXPECT_EQ(parse_axis("motion.preload=\"1 um\", 2 um").values, (Texts{"\"1 um\"", "2 um"}));
  EXPECT_EQ(parse_axis("slider.size=[3 mm, 1 mm],[2 mm, 1 mm]").values,
            (Texts{"[3 mm, 1 mm]", "[2 mm, 1 mm]"}));
  EXPECT_EQ(parse_axis("numerics.preset=coarse").values, Texts{"coarse"});
  EXPECT_EQ(parse_axis("a=-1e-3,2 m/s,1e-5 m2").values, (Texts{"-1e-3", "2 m/s", "1e-5 m2"}));
  EXPECT_EQ(parse_axis("motion.file=1/../path.csv").values, Texts{"1/../path.csv"});
}

TEST(SweepAxis, TwoEndsAreAnInterval) {
  const SweepAxis axis = parse_axis("motion.preload=0.5:2 um");
  ASSERT_TRUE(axis.interval);
  EXPECT_EQ(axis.interval->lower, 0.5);
  EXPECT_EQ(axis.interval->upper, 2.0);
  EXPECT_EQ(axis.interval->unit, "um");
  EXPECT_TRUE(axis.values.empty());
}

TEST(SweepAxis, NamesWhatIsWrong) {
  for (const char* argument : {"contact.friction", "=1", "a=", "a=1,,2", "a=1:0:2", "a=1:1:0",
                               "a=1:2:3:4", "a=2:1", "a=x:1:2", "a=0:1e-9:1", "a=0.1..0.5",
                               "a=0.1-0.5", "a=1 to 2", "a=1 - 2", "a=1 mm..2 mm"}) {
    const auto message = results::message_of<UserError>([&] { parse_axis(argument); });
    EXPECT_NE(message.find(argument), std::string::npos) << argument << ": " << message;
    EXPECT_NE(message.find("  = write"), std::string::npos) << argument;
  }
}

} // namespace
} // namespace ionskin::study
