// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/sweep/sweep.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/planning/output_size.hpp"
#include "scratch_folder.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
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

TEST(Sweep, DoesNotRefusePointsWhoseContactIsSolvedWhenMemoryHasBecomeScarce) {
  const SweepPlan plan =
      plan_sweep({.case_path = IONSKIN_CASES "/paper/coarse.toml",
                  .set_edits = {"numerics.mesh_refinement=0.5", "numerics.error_estimate=off",
                                "motion.cycles=1"},
                  .over = {"contact.friction=0.1,0.3"}});
  const results::ScratchFolder scratch;
  const LimitedMemory memory;
  SweepOptions options{.folder = scratch / "out", .studies = Studies::mechanics, .report = false};
  options.progress = [](std::string_view, double) { setenv(limit, "10 MB", 1); };
  const SweepOutcome outcome = run_sweep(plan, options);
  EXPECT_EQ(outcome.points, 2U);
  EXPECT_EQ(outcome.failures, (std::map<std::string, std::string>{}));
  SweepOptions another{.folder = scratch / "another", .report = false};
  EXPECT_NE(results::message_of<UserError>([&] { run_sweep(plan, another); }).find(limit),
            std::string::npos)
      << "before any work";
}

TEST(Sweep, IsRefusedBeforeAnyWorkWhereItsFilesFindNoRoomTogether) {
  const SweepPlan plan = plan_sweep(
      {.case_path = IONSKIN_CASES "/paper/coarse.toml", .over = {"contact.friction=0.1,0.3"}});
  const results::ScratchFolder scratch;
  const SweepOptions options{.folder = scratch / "out", .report = false};
  const double one = planning::expected_output(plan.points.front().input, true);
  setenv("IONSKIN_DISK_LIMIT", fmt::format("{} MB", 1.5e-6 * one).c_str(), 1);
  for (const auto& [what, start] : std::map<std::string, std::function<void()>>{
           {"sweep", [&] { run_sweep(plan, options); }},
           {"plan", [&] { plan_sweep_folder(plan, options); }}}) {
    EXPECT_NE(results::message_of<UserError>(start).find("IONSKIN_DISK_LIMIT"), std::string::npos)
        << what;
    EXPECT_FALSE(std::filesystem::exists(options.folder)) << what;
  }
  unsetenv("IONSKIN_DISK_LIMIT");
  plan_sweep_folder(plan, options);
  setenv("IONSKIN_DISK_LIMIT", "1 kB", 1);
  EXPECT_NE(
      results::message_of<UserError>([&] { do_batch(0, options); }).find("IONSKIN_DISK_LIMIT"),
      std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(options.folder / "points"));
  unsetenv("IONSKIN_DISK_LIMIT");
}

} // namespace
} // namespace ionskin::study
