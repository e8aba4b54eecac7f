// SPDX-License-Identifier: Apache-2.0
#include "ionskin/base/system/available_memory.hpp"

#include "ionskin/base/error.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

namespace ionskin::base {
namespace {

/// Sets the variable for one test.
class Limit {
public:
  explicit Limit(const char* text) { setenv("IONSKIN_MEMORY_LIMIT", text, 1); }
  ~Limit() { unsetenv("IONSKIN_MEMORY_LIMIT"); }
  Limit(const Limit&) = delete;
  Limit& operator=(const Limit&) = delete;
};

TEST(AvailableMemory, IsWhatTheEnvironmentAllows) {
  const Limit limit("12 GB");
  EXPECT_EQ(available_memory().bytes, 12e9);
}

TEST(AvailableMemory, RefusesWhatIsNoSize) {
  const Limit limit("much");
  EXPECT_THROW(available_memory(), UserError);
}

TEST(AvailableMemory, IsSomeOnEveryMachine) {
  EXPECT_GT(available_memory().bytes, 1e6);
  EXPECT_FALSE(available_memory().bound.empty());
}

} // namespace
} // namespace ionskin::base
