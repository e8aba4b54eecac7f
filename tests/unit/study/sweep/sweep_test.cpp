// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/sweep/sweep.hpp"

#include "ionskin/base/error.hpp"
#include "scratch_folder.hpp"

#include <gtest/gtest.h>

#include <map>
#include <stdlib.h>
#include <string>
#include <string_view>

namespace ionskin::study {
namespace {

constexpr const char* limit = "IONSKIN_MEMORY_LIMIT";

/// The limit goes with the test, however it ends.
struct LimitedMemory {
  LimitedMemory() { setenv(limit, "64 GB", 1); }
  ~LimitedMemory() { unsetenv(limit); }
};

TEST(Sweep, does_not_refuse_points_whose_contact_is_solved_when_memory_has_become_scarce) {
  const SweepPlan plan =
      plan_sweep({.case_path = IONSKIN_CASES "/quick.toml",
                  .set_edits = {"numerics.mesh_refinement=0.5", "numerics.error_estimate=off",
                                "motion.cycles=1"},
                  .over = {"contact.friction=0.1,0.3"}});
  const results::ScratchFolder scratch;
  const LimitedMemory memory;
  SweepOptions options{.folder = scratch / "out",
                       .studies = Studies::mechanics,
                       .report = false,
                       .use_cache = false};
  options.progress = [](std::string_view, double) { setenv(limit, "10 MB", 1); };
  const SweepOutcome outcome = run_sweep(plan, options);
  EXPECT_EQ(outcome.points, 2U);
  EXPECT_EQ(outcome.failures, (std::map<std::string, std::string>{}));
  SweepOptions another{.folder = scratch / "another", .report = false, .use_cache = false};
  EXPECT_NE(results::message_of<UserError>([&] { run_sweep(plan, another); }).find(limit),
            std::string::npos)
      << "before any work";
}

} // namespace
} // namespace ionskin::study
