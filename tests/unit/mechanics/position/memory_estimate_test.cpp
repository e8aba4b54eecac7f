// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/position/memory_estimate.hpp"

#include <gtest/gtest.h>

namespace ionskin::mechanics {
namespace {

TEST(MemoryEstimate, factors_that_do_not_fit_together_are_held_one_at_a_time) {
  const std::size_t large = 600000;
  EXPECT_EQ(factorisations_memory(large, 8), factorisation_memory(large));
}

TEST(MemoryEstimate, small_factors_are_held_by_every_thread) {
  const std::size_t small = 20000;
  EXPECT_EQ(factorisations_memory(small, 2), 2 * factorisation_memory(small));
}

} // namespace
} // namespace ionskin::mechanics
