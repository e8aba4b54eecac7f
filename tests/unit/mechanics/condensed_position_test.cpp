// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/condensed_position.hpp"

#include "ionskin/mechanics/find_footprint.hpp"
#include "scratch_folder.hpp"
#include "small_case.hpp"

#include <gtest/gtest.h>

namespace ionskin::mechanics {
namespace {

class CondensedPositionTest : public testing::Test {
protected:
  /// Whether a position holds a factor, for want of the response to every unit force.
  bool holds_factor(base::DiskCache& cache, bool many_states) const {
    return CondensedPosition(model_, input_.slider.start, {&cache, many_states}).holds_factor();
  }
  results::ScratchFolder folder_;

private:
  Case input_ = small_case();
  SkinModel model_{input_, find_footprint(input_, input_.contact.friction, 1)};
};

TEST_F(CondensedPositionTest, makes_the_response_for_many_states_or_when_it_comes_again) {
  base::DiskCache cache(folder_.path(), 1'000'000'000);
  EXPECT_TRUE(holds_factor(cache, false));
  EXPECT_FALSE(holds_factor(cache, false));
  base::DiskCache other(folder_ / "other", 1'000'000'000);
  EXPECT_FALSE(holds_factor(other, true));
}

TEST_F(CondensedPositionTest, makes_no_response_that_the_cache_has_no_room_for) {
  base::DiskCache cache(folder_.path(), 1'000'000);
  EXPECT_TRUE(holds_factor(cache, true));
  EXPECT_TRUE(holds_factor(cache, false));
}

} // namespace
} // namespace ionskin::mechanics
