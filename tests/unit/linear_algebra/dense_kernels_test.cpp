// SPDX-License-Identifier: Apache-2.0
#include "ionskin/linear_algebra/dense_kernels.hpp"

#include <gtest/gtest.h>

#include <array>
#include <set>
#include <string>
#include <thread>
#include <vector>

namespace ionskin::linear_algebra {
namespace {

TEST(DenseKernels, HaveOneNameForAllThreads) {
  std::array<std::set<std::string>, 4> names;
  {
    std::vector<std::jthread> threads;
    for (auto& found : names) {
      threads.emplace_back([&found] {
        for (int i = 0; i < 20000; ++i) {
          found.insert(kernel_name());
        }
      });
    }
  }
  const std::set<std::string> expected{kernel_name()};
  for (const auto& found : names) {
    EXPECT_EQ(found, expected);
  }
}

} // namespace
} // namespace ionskin::linear_algebra
