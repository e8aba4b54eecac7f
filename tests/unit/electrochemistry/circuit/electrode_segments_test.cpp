// SPDX-License-Identifier: Apache-2.0
#include "ionskin/electrochemistry/circuit/electrode_segments.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace ionskin::electrochemistry {
namespace {

/// 4 x 2 columns of 1 mm by 1 mm.
TransportGrid grid() {
  return {{0, 1e-3, 2e-3, 3e-3, 4e-3}, {0, 1e-3, 2e-3}, {0, 1e-4}};
}

std::vector<double> any_charge() {
  std::vector<double> charge(8);
  for (std::size_t i = 0; i < charge.size(); ++i) {
    charge[i] = std::cos(3.0 * static_cast<double>(i)) * 1e-9;
  }
  return charge;
}

TEST(ElectrodeSegments, TakeTheShareOfTheColumnsThatTheyCover) {
  const auto segments =
      make_electrode_segments({{"a", {0.25e-3, 0.5e-3}, {2e-3, 1.75e-3}}}, grid());
  ASSERT_EQ(segments.names, (std::vector<std::string>{"a", "rest"}));
  const std::vector<double> expected{0.375, 0.5, 0, 0, 0.5625, 0.75, 0, 0};
  for (std::size_t i = 0; i < 8; ++i) {
    EXPECT_NEAR(segments.share[0][i], expected[i], 1e-15);
  }
}

TEST(ElectrodeSegments, AddUpToTheWholeElectrode) {
  const std::vector<double> charge = any_charge();
  const double whole = std::accumulate(charge.begin(), charge.end(), 0.0);
  const auto segments = make_electrode_segments({{"a", {0, 0}, {1.7e-3, 0.3e-3}},
                                                 {"b", {1.7e-3, 0.1e-3}, {2.9e-3, 2e-3}},
                                                 {"c", {0, 0.3e-3}, {1.7e-3, 2e-3}}},
                                                grid());
  EXPECT_EQ(segments.names.back(), "rest");
  const auto charges = segments.charges(charge);
  EXPECT_NEAR(std::accumulate(charges.begin(), charges.end(), 0.0), whole, 1e-12 * std::abs(whole));
}

TEST(ElectrodeSegments, LeaveNoRestWhereTheyCoverTheFace) {
  const auto segments = make_electrode_segments(
      {{"a", {0, 0}, {1.3e-3, 2e-3}}, {"b", {1.3e-3, 0}, {4e-3, 2e-3}}}, grid());
  EXPECT_EQ(segments.names.size(), 2u);
  EXPECT_TRUE(make_electrode_segments({}, grid()).names.empty());
}

} // namespace
} // namespace ionskin::electrochemistry
