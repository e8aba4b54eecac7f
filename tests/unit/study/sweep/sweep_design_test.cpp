// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/sweep/sweep_design.hpp"

#include "ionskin/base/error.hpp"

#include <gtest/gtest.h>

#include <set>

namespace ionskin::study {
namespace {

/// Number of equal slices of [0, 1) that a coordinate of the points meets.
std::size_t slices_met(const std::vector<std::vector<double>>& points, std::size_t dimension) {
  std::set<std::size_t> met;
  for (const auto& point : points) {
    met.insert(static_cast<std::size_t>(point[dimension] * static_cast<double>(points.size())));
  }
  return met.size();
}

TEST(SweepDesign, GridRunsTheLastAxisFastest) {
  const std::vector<SweepAxis> axes{{"a", {"1", "2"}, {}}, {"b", {"x", "y", "z"}, {}}};
  const auto points = grid_design(axes);
  ASSERT_EQ(points.size(), 6u);
  EXPECT_EQ(points[0], (std::vector<std::string>{"1", "x"}));
  EXPECT_EQ(points[1], (std::vector<std::string>{"1", "y"}));
  EXPECT_EQ(points[5], (std::vector<std::string>{"2", "z"}));
}

TEST(SweepDesign, BothSamplingsMeetEverySlice) {
  for (const Sampling sampling : {Sampling::sobol, Sampling::latin_hypercube}) {
    // A digitally shifted Sobol sequence does so for whole powers of 2 from its start.
    const auto points = unit_points(sampling, 64, 3, 7);
    ASSERT_EQ(points.size(), 64u);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_GE(slices_met(points, i), sampling == Sampling::sobol ? 63u : 64u);
    }
  }
}

TEST(SweepDesign, TheSeedDecides) {
  for (const Sampling sampling : {Sampling::sobol, Sampling::latin_hypercube}) {
    EXPECT_EQ(unit_points(sampling, 9, 2, 1), unit_points(sampling, 9, 2, 1));
    EXPECT_NE(unit_points(sampling, 9, 2, 1), unit_points(sampling, 9, 2, 2));
  }
}

TEST(SweepDesign, SamplesStayWithinTheirIntervals) {
  const std::vector<SweepAxis> axes{{"a", {}, SweepAxis::Interval{0.1, 0.2, ""}},
                                    {"b", {}, SweepAxis::Interval{2, 3, "um"}}};
  for (const auto& point : sampled_design(axes, Sampling::sobol, 20, 3)) {
    EXPECT_GE(std::stod(point[0]), 0.1);
    EXPECT_LE(std::stod(point[0]), 0.2);
    EXPECT_GE(std::stod(point[1]), 2);
    EXPECT_TRUE(point[1].ends_with(" um"));
  }
}

TEST(SweepDesign, ValuesAndIntervalsDoNotMix) {
  const SweepAxis values{"a", {"1"}, {}};
  const SweepAxis interval{"b", {}, SweepAxis::Interval{0, 1, ""}};
  EXPECT_THROW(grid_design({values, interval}), UserError);
  EXPECT_THROW(sampled_design({values, interval}, Sampling::sobol, 2, 1), UserError);
}

TEST(SweepDesign, GridsHaveABound) {
  const std::vector<std::string> many(1000, "1");
  EXPECT_THROW(grid_design({{"a", many, {}}, {"b", many, {}}}), UserError);
}

} // namespace
} // namespace ionskin::study
