// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/sweep/sweep_plan_file.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/results/output_folder.hpp"
#include "ionskin/results/summary_json.hpp"
#include "ionskin/study/run/run_folder.hpp"
#include "ionskin/study/sweep/sweep_folder.hpp"
#include "scratch_folder.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <limits>

namespace ionskin::study {
namespace {

class SweepPlanFile : public testing::Test {
protected:
  void SetUp() override {
    plan_ = plan_sweep({.case_path = IONSKIN_CASES "/quick.toml",
                        .set_edits = {"motion.preload=1.1 um"},
                        .over = {"contact.friction=0.1,0.3", "coupling.coefficient=0.07,0.1"}});
    batches_ = plan_batches(plan_.points, Studies::both, 1);
    write(plan_text(plan_, batches_, Studies::both));
  }
  void write(const std::string& text) const {
    std::ofstream(folder_.path() / results::file_names::sweep_plan) << text;
  }
  results::ScratchFolder folder_;
  SweepPlan plan_;
  std::vector<SweepBatch> batches_;
};

TEST_F(SweepPlanFile, WhatAPointNeedsIsReadBackToTheLastBit) {
  const PlannedSweep read = read_planned_sweep(folder_.path(), std::nullopt);
  EXPECT_EQ(plan_text(read.plan, read.batches, read.studies),
            plan_text(plan_, batches_, Studies::both));
  std::size_t points = 0;
  for (std::size_t batch = 0; batch < batches_.size(); ++batch) {
    const PlannedSweep part = read_planned_sweep(folder_.path(), batch);
    for (const std::size_t i : part.batches[batch].points) {
      const Case &own = part.plan.points[i].input, &planned = plan_.points[i].input;
      EXPECT_EQ(own.values, planned.values);
      EXPECT_EQ(mechanics_hash(own), plan_.points[i].mechanics_hash);
      EXPECT_EQ(std::bit_cast<std::uint64_t>(own.motion.preload),
                std::bit_cast<std::uint64_t>(planned.motion.preload));
      ++points;
    }
  }
  EXPECT_EQ(points, 4u);
}

TEST_F(SweepPlanFile, ADamagedPlanIsRefused) {
  std::string text = plan_text(plan_, batches_, Studies::both);
  text.replace(text.find("0.07"), 4, "0.08");
  write(text);
  EXPECT_THROW(read_planned_sweep(folder_.path(), 0), UserError);
}

TEST_F(SweepPlanFile, WhatAPointGivesIsReadBackToTheLastBit) {
  const SweepPoint& point = plan_.points.front();
  const std::vector<readout::Metric> given{
      {"third", 1.0 / 3.0, "A"},
      {"negative zero", -0.0, "1"},
      {"smallest", std::numeric_limits<double>::denorm_min(), "C"},
      {"largest", std::numeric_limits<double>::max(), "1"},
      {"next to 0.1", std::nextafter(0.1, 1.0), "N"}};
  RunFolder run(point.input, {.folder = folder_.path() / point.name});
  results::Summary summary;
  summary.metrics = given;
  results::write_summary(run.own(results::file_names::summary), summary);
  run.add_finished("electrochemistry", 1);
  run.finish(true);
  const PointState state = read_point_state(folder_.path(), point, Studies::both);
  ASSERT_EQ(state.status, PointStatus::finished);
  ASSERT_EQ(state.metrics.size(), given.size());
  for (std::size_t i = 0; i < given.size(); ++i) {
    EXPECT_EQ(state.metrics[i].name, given[i].name);
    EXPECT_EQ(state.metrics[i].unit, given[i].unit);
    EXPECT_EQ(std::bit_cast<std::uint64_t>(state.metrics[i].value),
              std::bit_cast<std::uint64_t>(given[i].value))
        << given[i].name;
  }
}

} // namespace
} // namespace ionskin::study
