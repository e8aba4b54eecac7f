// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/engine/path_thinning.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace ionskin::mechanics {
namespace {

TEST(PathThinning, KeepsWhatStraightLinesMiss) {
  std::vector<double> kept;
  PathThinning thinning({1e-2, 1, 1, 1},
                        [&](PathThinning::Instant&& instant) { kept.push_back(instant.time); });
  for (int i = 0; i <= 100; ++i) {
    const double time = 0.01 * i;
    thinning.add({time, {0, 0}, 0, i == 20, 0, 0, {1 + std::max(0.0, time - 0.5), 0, 0}, nullptr});
  }
  thinning.finish();
  ASSERT_EQ(kept.size(), 4u); // begin, required, before the bend, end
  EXPECT_EQ(kept[1], 0.2);
  EXPECT_NEAR(kept[2], 0.51, 0.02);
  EXPECT_EQ(kept.back(), 1);
}

TEST(PathThinning, RoundingDoesNotPassTheLongestWay) {
  for (const double rounding : {-1e-12, 0.0, 1e-12}) {
    int kept = 0;
    PathThinning thinning({1e-2, 1, 1, 0.1}, [&](PathThinning::Instant&&) { ++kept; });
    for (int i = 0; i <= 20; ++i) {
      thinning.add({0.1 * i, {0.05 * i * (1 + rounding), 0}, 0, false, 0, 0, {1, 0, 0}, nullptr});
    }
    thinning.finish();
    EXPECT_EQ(kept, 11);
  }
}

} // namespace
} // namespace ionskin::mechanics
