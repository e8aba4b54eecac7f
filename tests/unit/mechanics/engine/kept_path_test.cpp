// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/engine/kept_path.hpp"
#include "small_line.hpp"

#include <gtest/gtest.h>

namespace ionskin::mechanics {
namespace {

TEST(KeptPath, CountsASliderBelowTheSkinWithoutLoadAsAViolation) {
  ContactSolution solution{.mesh = line().model->mesh};
  KeptPath path(*line().model, nullptr, {1e-2, 1, 1, 0.1}, solution);
  const SlidingContact slider = line().slider();
  path.add({0, {2e-3, 1e-3}, 1e-3, false, true, {}}, slider);
  EXPECT_EQ(solution.worst_complementarity_residual, 0);
  path.add({1, {2e-3, 1e-3}, -1e-6, false, true, {}}, slider);
  EXPECT_EQ(solution.worst_complementarity_residual, 1);
}

} // namespace
} // namespace ionskin::mechanics
