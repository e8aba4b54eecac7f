// SPDX-License-Identifier: Apache-2.0
#include "ionskin/readout/taxels.hpp"

#include <gtest/gtest.h>

namespace ionskin::readout {
namespace {

TEST(Taxels, CurrentsAreMeansOverTheStepsAndChargesFollow) {
  const SignalTable table =
      taxel_signals({0, 0.5, 1.5}, {{"left", {1, 2, 4}}, {"rest", {0, -3, -3}}});
  ASSERT_EQ(table.columns.size(), 5u);
  EXPECT_EQ(table.columns[1].name, "current_top_left");
  EXPECT_EQ(table.columns[1].unit, "A");
  EXPECT_EQ(table.columns[1].values, (std::vector<double>{0, 2, 2}));
  EXPECT_EQ(table.column("current_top_rest").values, (std::vector<double>{0, -6, 0}));
  EXPECT_EQ(table.columns[3].name, "charge_top_left");
  EXPECT_EQ(table.column("charge_top_rest").unit, "C");
  EXPECT_EQ(table.column("charge_top_rest").values, (std::vector<double>{0, -3, -3}));
}

TEST(Taxels, WithABottomChargeTheOddAndTheEvenPartAreReported) {
  const SignalTable table = taxel_signals({0, 1}, {{"left", {0, 4}, {0, -2}}});
  EXPECT_EQ(table.column("charge_odd_left").values, (std::vector<double>{0, 3}));
  EXPECT_EQ(table.column("current_even_left").values, (std::vector<double>{0, 1}));
  EXPECT_EQ(taxel_balance_error(table, {0, 4}), 0);
}

TEST(Taxels, LargestCurrentIsThatOfATaxelAndNotOfTheRest) {
  const SignalTable table =
      taxel_signals({0, 0.5, 1.5}, {{"a", {1, 2, 4}}, {"b", {0, -1.5, -2}}, {"rest", {0, -9, -3}}});
  EXPECT_DOUBLE_EQ(largest_taxel_current(table), 3);
}

TEST(Taxels, BalanceIsAgainstTheWholeElectrode) {
  const SignalTable table =
      taxel_signals({0, 0.5, 1.5}, {{"left", {1, 2, 4}}, {"rest", {0, -3, -3}}});
  EXPECT_EQ(taxel_balance_error(table, {0, -4, 2}), 0);
  EXPECT_DOUBLE_EQ(taxel_balance_error(table, {0, -5, 2}), 1.0 / 5);
  EXPECT_EQ(taxel_balance_error(taxel_signals({0, 1}, {{"a", {2, 2}}}), {0, 0}), 0);
  EXPECT_FALSE(carry_current(taxel_signals({0, 1}, {{"a", {2, 2}}})));
  EXPECT_TRUE(carry_current(taxel_signals({0, 1}, {{"a", {2, 2}}, {"b", {0, 1}}})));
}

} // namespace
} // namespace ionskin::readout
