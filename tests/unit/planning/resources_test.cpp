// SPDX-License-Identifier: Apache-2.0
#include "ionskin/planning/resources.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/case/reading/read_case.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

namespace ionskin::planning {
namespace {

Case quick(const std::vector<std::string>& edits = {}) {
  return read_case(IONSKIN_CASES "/quick.toml", edits);
}

TEST(Resources, OfAQuickCaseAreThere) {
  EXPECT_EQ(shortage(quick(), 2), "");
}

TEST(Resources, BeyondTheLimitAreRefusedWithTheNumbers) {
  setenv("IONSKIN_MEMORY_LIMIT", "100 MB", 1);
  EXPECT_THAT(shortage(quick(), 2), testing::HasSubstr("0.1 GB are allowed"));
  EXPECT_THROW(require_resources(quick(), 2), UserError);
  unsetenv("IONSKIN_MEMORY_LIMIT");
}

TEST(Resources, OfThinFilmsAreRefusedBeforeTheyAreBuilt) {
  const Case films = quick({"skin.layers[0].thickness=200 nm", "skin.layers[1].thickness=200 nm",
                            "skin.layers[2].thickness=200 nm", "motion.preload=1 nm"});
  EXPECT_THROW(require_resources(films, 2), UserError);
}

TEST(Resources, StepsWithoutEndAreRefused) {
  EXPECT_THROW(
      require_resources(quick({"motion.slide=10000000 s", "electrochemistry.diffusivity=1e-4 m2/s",
                               "numerics.time_refinement=100", "readout.sample_interval=100 s",
                               "output.fields=[]"}),
                        2),
      UserError);
}

} // namespace
} // namespace ionskin::planning
