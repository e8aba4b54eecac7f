// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/position/position_memory.hpp"

#include <gtest/gtest.h>

namespace ionskin::mechanics {
namespace {

base::Digest key(int number) {
  return base::DigestBuilder().add(number).finish();
}

/// Of 800 bytes.
std::shared_ptr<const StoredPosition> position() {
  return std::make_shared<const StoredPosition>(
      StoredPosition{linear_algebra::DenseMatrix(10, 10), {}});
}

TEST(PositionMemory, keeps_nothing_unless_it_is_given_room) {
  PositionMemory memory;
  memory.keep(key(1), position());
  EXPECT_EQ(memory.find(key(1)), nullptr);
}

TEST(PositionMemory, forgets_the_least_recently_used_beyond_its_bound) {
  PositionMemory memory;
  memory.set_bound(2 * bytes_of(*position()));
  EXPECT_EQ(bytes_of(*position()), 800u);
  const auto first = position();
  memory.keep(key(1), first);
  memory.keep(key(2), position());
  EXPECT_EQ(memory.find(key(1)), first);
  memory.keep(key(3), position());
  EXPECT_EQ(memory.find(key(2)), nullptr);
  EXPECT_EQ(memory.find(key(1)), first);
  memory.set_bound(0);
  EXPECT_EQ(memory.find(key(1)), nullptr);
}

TEST(PositionMemory, replaces_what_has_fewer_directions) {
  PositionMemory memory;
  memory.set_bound(10'000);
  memory.keep(key(1), position());
  const auto other = position();
  memory.keep(key(1), other);
  EXPECT_EQ(memory.find(key(1)), other);
}

} // namespace
} // namespace ionskin::mechanics
