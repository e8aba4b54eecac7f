// SPDX-License-Identifier: Apache-2.0
#include "ionskin/parallel/shared_progress.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace ionskin::parallel {
namespace {

TEST(SharedProgress, NeverFallsAndEndsAtOne) {
  std::vector<double> seen;
  const base::ProgressCallback callback = [&seen](std::string_view, double fraction) {
    seen.push_back(fraction);
  };
  SharedProgress progress("contact", callback);
  // More units than expected, then a second pass that nobody foresaw.
  progress.begin_pass(4, 0.9);
  progress.add_units(6);
  for (int unit = 0; unit < 6; ++unit) {
    progress.finish_unit();
    progress.add_units(unit == 2 ? 5 : 0);
  }
  EXPECT_LT(seen.back(), 0.9);
  const double before = seen.back();
  progress.begin_pass(2, 1.0);
  progress.add_units(2);
  progress.finish_unit();
  EXPECT_NEAR(seen.back(), before + (1 - before) / 2, 1e-12);
  progress.finish_unit();
  progress.finish();
  EXPECT_TRUE(std::ranges::is_sorted(seen));
  EXPECT_EQ(seen.back(), 1.0);
}

} // namespace
} // namespace ionskin::parallel
