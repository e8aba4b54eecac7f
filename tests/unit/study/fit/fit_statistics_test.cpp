// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/fit/fit_statistics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

namespace ionskin::study {
namespace {

/// A straight line a + b x at x = 0...4, whose statistics textbooks give in closed form.
TEST(FitStatistics, OfAStraightLine) {
  const std::vector<double> data = {1.1, 1.9, 3.2, 3.9, 5.1},
                            residuals = {0.06, -0.14, 0.16, -0.14, 0.06};
  const FitStatistics statistics =
      fit_statistics(data, residuals, {{1, 1, 1, 1, 1}, {0, 1, 2, 3, 4}});
  const double deviation = std::sqrt(0.072 / 3);
  EXPECT_EQ(statistics.degrees_of_freedom, 3u);
  EXPECT_NEAR(statistics.residual_deviation, deviation, 1e-12);
  EXPECT_NEAR(statistics.log_error[0], deviation * std::sqrt(0.6), 1e-12);
  EXPECT_NEAR(statistics.log_error[1], deviation * std::sqrt(0.1), 1e-12);
  EXPECT_NEAR(statistics.correlation[0][1], -2 / std::sqrt(6.0), 1e-12);
  EXPECT_NEAR(statistics.quantile, 3.182446, 1e-6); // of t with 3 degrees of freedom
  // Eigenvalues of the normal matrix [[5, 10], [10, 30]].
  const double root = std::sqrt(12.5 * 12.5 + 100);
  EXPECT_NEAR(statistics.condition_number, std::sqrt((17.5 + root) / (17.5 - root)), 1e-9);
  EXPECT_NEAR(statistics.explained, 1 - 0.072 / 10.072, 1e-12);
}

TEST(FitStatistics, KeysThatCannotBeDistinguishedAreNamed) {
  const std::vector<double> data = {1, 2, 3, 4, 5}, noise = {0.01, -0.02, 0.01, 0.02, -0.01};
  const auto same = fit_statistics(data, noise, {{1, 2, 3, 4, 5}, {1, 2, 3, 4, 5}});
  EXPECT_TRUE(std::isinf(same.log_error[0]) && std::isinf(same.log_error[1]));
  const auto warnings = fit_warnings(same, {"a.first", "b.second"});
  ASSERT_FALSE(warnings.empty());
  EXPECT_NE(warnings[0].find("a.first^"), std::string::npos) << warnings[0];
  EXPECT_NE(warnings[0].find("b.second^"), std::string::npos) << warnings[0];
  for (const std::string& warning : warnings) {
    EXPECT_EQ(warning.find("inf"), std::string::npos) << warning;
  }

  const auto one_without_trace = fit_statistics(data, noise, {{1, 2, 3, 4, 5}, {0, 0, 0, 0, 0}});
  EXPECT_TRUE(std::isfinite(one_without_trace.log_error[0]));
  EXPECT_TRUE(std::isinf(one_without_trace.log_error[1]));
}

TEST(FitStatistics, DataWithoutTraceOfAKeyNameNoFactor) {
  const std::vector<double> data = {1, 2, 3, 4, 5.1}, noise = {0.1, -0.1, 0.1, -0.1, 0.05};
  const double least = 1e-9; // a trace, of which exp(half width) overflows
  for (const double trace : {0.0, least}) {
    const auto warnings =
        fit_warnings(fit_statistics(data, noise, {{trace, -trace, trace, trace, 0}}), {"a.key"});
    ASSERT_FALSE(warnings.empty());
    EXPECT_NE(warnings[0].find("do not fix a.key"), std::string::npos) << warnings[0];
    for (const std::string& warning : warnings) {
      EXPECT_EQ(warning.find("inf"), std::string::npos) << warning;
      EXPECT_EQ(warning.find("e+"), std::string::npos) << warning;
    }
  }
}

TEST(FitStatistics, GoodDataRaiseNoWarningAndAWrongModelDoes) {
  std::vector<double> data, noise, wrong, level, slope;
  std::uint32_t state = 1; // of a linear congruential generator
  for (int i = 0; i < 100; ++i) {
    data.push_back(3 + 0.1 * i);
    state = state * 1664525u + 1013904223u;
    noise.push_back(0.02 * (static_cast<double>(state >> 8) / 16777216.0 - 0.5));
    wrong.push_back(0.02 * std::sin(0.1 * i));
    level.push_back(3);
    slope.push_back(0.1 * (i - 49.5));
  }
  EXPECT_TRUE(fit_warnings(fit_statistics(data, noise, {level, slope}), {"a", "b"}).empty());
  const auto warnings = fit_warnings(fit_statistics(data, wrong, {level, slope}), {"a", "b"});
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_NE(warnings[0].find("not noise"), std::string::npos);

  // A fit to the signals of a run: what is left is rounding, whatever its course.
  for (double& residual : wrong) {
    residual *= 1e-5;
  }
  EXPECT_TRUE(fit_warnings(fit_statistics(data, wrong, {level, slope}), {"a", "b"}).empty());
}

} // namespace
} // namespace ionskin::study
