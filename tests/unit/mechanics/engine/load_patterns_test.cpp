// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/engine/load_patterns.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace ionskin::mechanics {
namespace {

/// Component of a load that is a combination of three patterns.
double component(std::size_t i, double time) {
  const double x = 0.1 * static_cast<double>(i);
  return std::exp(-x) + time * std::sin(x) + 1e-3 * time * time * x;
}

std::vector<CellVector> loads_of_path(std::size_t count) {
  std::vector<CellVector> loads;
  for (std::size_t k = 0; k < count; ++k) {
    CellVector& load = loads.emplace_back();
    for (std::size_t i = 0; i < 60; ++i) {
      load.push_back(component(i, 0.1 * static_cast<double>(k)));
    }
  }
  return loads;
}

/// What the combination of the chosen loads lacks of one, Euclidean norm.
double missing(const std::vector<CellVector>& loads, const LoadPatterns& patterns, std::size_t k) {
  double square = 0;
  for (std::size_t i = 0; i < loads[k].size(); ++i) {
    double rest = loads[k][i];
    for (std::size_t j = 0; j < patterns.chosen.size(); ++j) {
      rest -=
          patterns.share(static_cast<int>(j), static_cast<int>(k)) * loads[patterns.chosen[j]][i];
    }
    square += rest * rest;
  }
  return std::sqrt(square);
}

TEST(LoadPatterns, as_many_as_the_loads_differ_in) {
  const auto loads = loads_of_path(40);
  const LoadPatterns patterns = load_patterns(loads, 1e-9);
  EXPECT_EQ(patterns.chosen.size(), 3u);
  for (std::size_t k = 0; k < loads.size(); ++k) {
    EXPECT_LT(missing(loads, patterns, k), 1e-9) << k;
  }
}

TEST(LoadPatterns, leave_out_what_is_negligible_and_no_more) {
  const auto loads = loads_of_path(40);
  const LoadPatterns patterns = load_patterns(loads, 0.3);
  EXPECT_EQ(patterns.chosen.size(), 2u);
  double most = 0;
  for (std::size_t k = 0; k < loads.size(); ++k) {
    most = std::max(most, missing(loads, patterns, k));
  }
  EXPECT_LT(most, 0.3);
  EXPECT_GT(most, 1e-6);
}

TEST(LoadPatterns, of_loads_that_differ_in_all_are_themselves) {
  std::vector<CellVector> loads(5, CellVector(5));
  for (std::size_t i = 0; i < 5; ++i) {
    loads[i][i] = 1 + static_cast<double>(i);
  }
  const LoadPatterns patterns = load_patterns(loads, 1e-12);
  ASSERT_EQ(patterns.chosen.size(), 5u);
  for (std::size_t j = 0; j < 5; ++j) {
    for (std::size_t k = 0; k < 5; ++k) {
      EXPECT_EQ(patterns.share(static_cast<int>(j), static_cast<int>(k)),
                patterns.chosen[j] == k ? 1 : 0);
    }
  }
}

TEST(LoadPatterns, of_no_load_are_none) {
  const LoadPatterns patterns = load_patterns({CellVector(6), CellVector(6)}, 0);
  EXPECT_TRUE(patterns.chosen.empty());
  EXPECT_EQ(patterns.share.rows, 0);
}

} // namespace
} // namespace ionskin::mechanics
