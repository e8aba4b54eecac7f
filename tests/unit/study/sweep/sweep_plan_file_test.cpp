// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/sweep/sweep_plan_file.hpp"

#include "ionskin/base/digest.hpp"
#include "ionskin/base/error.hpp"
#include "ionskin/base/files/read_json.hpp"
#include "ionskin/results/output_folder.hpp"
#include "ionskin/results/summary_json.hpp"
#include "ionskin/study/run/run_folder.hpp"
#include "ionskin/study/sweep/sweep_folder.hpp"
#include "scratch_folder.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <limits>
#include <string>
#include <string_view>
#include <sys/stat.h>
#include <vector>

namespace ionskin::study {
namespace {

class SweepPlanFile : public testing::Test {
protected:
  void SetUp() override {
    plan_ = plan_sweep({.case_path = IONSKIN_CASES "/paper/coarse.toml",
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

/// A change, and the digest made anew, as whoever changes a plan on purpose does.
std::string forged(const std::string& text, const std::function<void(base::Json&)>& change) {
  base::Json json = *base::parse_json(text);
  json.erase("digest");
  change(json);
  const std::string content = json.dump(1, ' ', false) + "\n";
  json["digest"] = base::DigestBuilder().add(std::string_view(content)).finish().hex();
  return json.dump(1, ' ', false) + "\n";
}

TEST_F(SweepPlanFile, AForgedPlanIsRefused) {
  const std::string whole = plan_text(plan_, batches_, Studies::both);
  ASSERT_EQ(forged(whole, [](base::Json&) {}), whole) << "the digest is made as ionskin makes it";
  using Json = base::Json;
  const double infinite = std::numeric_limits<double>::infinity();
  const std::vector<std::function<void(Json&)>> changes{
      [](Json& plan) { plan["batches"][0]["points"][0]["name"] = "../../x"; },
      [](Json& plan) { plan["batches"][0]["points"][0]["name"] = "/tmp/x"; },
      [](Json& plan) { plan["batches"][0]["points"][0]["name"] = 3; },
      [](Json& plan) { plan["batches"][0]["points"][0].erase("name"); },
      [](Json& plan) { plan["batches"][0]["points"][0]["number"] = 0; },
      [](Json& plan) { plan["batches"][0]["points"][0]["number"] = 2; },
      [](Json& plan) { plan["batches"][0]["points"][0]["number"] = 5; },
      [](Json& plan) { plan["batches"][0]["points"][0]["number"] = -1; },
      [](Json& plan) { plan["batches"][0]["points"][0]["number"] = 1e300; },
      [](Json& plan) { plan["batches"][0]["points"][0]["number"] = "1"; },
      [](Json& plan) { plan["batches"][0]["points"][0]["edits"][0] = "contact.friction=0.9"; },
      [](Json& plan) {
        plan["batches"][0]["points"][0]["edits"][0] = "slider.profile=/etc/passwd";
      },
      [](Json& plan) { plan["batches"][0]["points"][0]["edits"] = Json::array(); },
      [](Json& plan) { plan["batches"][0]["points"][0]["values"].erase(0); },
      [](Json& plan) { plan["batches"][0]["points"][0]["values"] = 7; },
      [](Json& plan) { plan["batches"][0]["points"][0]["values"][0]["si"] = "nan"; },
      [](Json& plan) { plan["batches"][0]["points"][0]["values"][0]["si"] = "1e999"; },
      [](Json& plan) { plan["batches"][0]["points"][0]["values"][0]["unit"] = "1,\n"; },
      [](Json& plan) { plan["batches"][0]["points"][0]["values"][0]["unit"] = "m"; },
      [](Json& plan) { plan["batches"][0]["points"][0]["input_hash"] = "../x"; },
      [](Json& plan) { plan["batches"][0]["points"][0]["mechanics_hash"] = nullptr; },
      [](Json& plan) { plan["batches"][0]["points"].erase(0); },
      [](Json& plan) { plan["batches"][0]["points"] = Json::array(); },
      [](Json& plan) { plan["batches"][0]["points"].push_back(plan["batches"][0]["points"][0]); },
      [](Json& plan) { plan["batches"][0]["number"] = 1; },
      [](Json& plan) { plan["batches"][0]["threads"] = 0; },
      [](Json& plan) { plan["batches"][0]["threads"] = -1; },
      [](Json& plan) { plan["batches"][0]["threads"] = 4'000'000'000; },
      [](Json& plan) { plan["batches"][0]["threads"] = 1.5; },
      [](Json& plan) { plan["batches"][0]["memory_bytes"] = -1.0; },
      [](Json& plan) { plan["batches"][0]["memory_bytes"] = 1e300; },
      [=](Json& plan) { plan["batches"][0]["seconds"] = infinite; },
      [](Json& plan) { plan["batches"][0]["seconds"] = "soon"; },
      [](Json& plan) { plan["batches"][0]["contact_solutions"] = 1'000'000; },
      [](Json& plan) { plan["batches"][0]["more"] = 1; },
      [](Json& plan) { plan["batches"] = Json::array(); },
      [](Json& plan) { plan["batches"] = Json::object(); },
      [](Json& plan) { plan["batches"].push_back(plan["batches"][0]); },
      [](Json& plan) { plan["points"] = 0; },
      [](Json& plan) { plan["points"] = 3; },
      [](Json& plan) { plan["points"] = 5; },
      [](Json& plan) { plan["points"] = 1'000'000'000'000'000'000; },
      [](Json& plan) { plan["points"] = -1; },
      [](Json& plan) { plan.erase("points"); },
      [](Json& plan) { plan["only"] = "ions"; },
      [](Json& plan) { plan["only"] = 3; },
      [](Json& plan) { plan["sweep"] = Json::array(); },
      [](Json& plan) { plan["sweep"]["over"] = Json::array(); },
      [](Json& plan) { plan["sweep"]["over"][0] = "contact.friction=0.1:1e-9:0.3"; },
      [](Json& plan) { plan["sweep"]["over"][0] = "contact/../../x=0.1,0.3"; },
      [](Json& plan) { plan["sweep"]["over"][1] = plan["sweep"]["over"][0]; },
      [](Json& plan) { plan["sweep"]["samples"] = 1'000'000'000'000'000'000; },
      [](Json& plan) { plan["sweep"]["samples"] = -1; },
      [](Json& plan) { plan["sweep"]["samples"] = 1e30; },
      [](Json& plan) { plan["sweep"]["sampling"] = "none"; },
      [](Json& plan) { plan["sweep"]["seed"] = -1; },
      [](Json& plan) { plan["sweep"]["set"] = std::vector<std::string>(2000, "slider.start=1"); },
      [](Json& plan) { plan["sweep"]["case_path"] = 3; },
      [](Json& plan) { plan["sweep"]["case_text"] = "[contact]\nfriction = 0.2"; },
      [](Json& plan) { plan["sweep"]["case_text"] = std::string(1'000'000, '['); },
      [](Json& plan) { plan["program"]["version"] = 7; },
      [](Json& plan) { plan["build"] = 3; },
      [](Json& plan) { plan.erase("build"); }};
  for (std::size_t i = 0; i < changes.size(); ++i) {
    write(forged(whole, changes[i]));
    EXPECT_THROW(read_planned_sweep(folder_.path(), 0), UserError) << "change " << i;
    EXPECT_THROW(read_planned_sweep(folder_.path(), std::nullopt), UserError) << "change " << i;
  }
}

TEST_F(SweepPlanFile, WhatIsNotAPlanIsRefused) {
  const std::string whole = plan_text(plan_, batches_, Studies::both),
                    deep = std::string(1'000'000, '[') + std::string(1'000'000, ']');
  for (const std::string& text :
       {std::string(), std::string("3"), std::string("[]"), std::string("{}"), std::string("null"),
        deep, "{\"digest\":\"\",\"batches\":" + deep + "}", whole.substr(0, whole.size() / 2),
        whole + "x"}) {
    write(text);
    EXPECT_THROW(read_planned_sweep(folder_.path(), 0), UserError) << text.substr(0, 20);
  }
  const auto path = folder_.path() / results::file_names::sweep_plan;
  std::filesystem::remove(path);
  ASSERT_EQ(mkfifo(path.c_str(), 0600), 0);
  EXPECT_THROW(read_planned_sweep(folder_.path(), 0), UserError) << "a pipe";
  std::filesystem::remove(path);
  std::filesystem::create_directory(path);
  EXPECT_THROW(read_planned_sweep(folder_.path(), 0), UserError) << "a folder";
  std::filesystem::remove(path);
  std::filesystem::create_symlink(path, path);
  EXPECT_THROW(read_planned_sweep(folder_.path(), 0), UserError) << "a link to itself";
}

TEST(SweepPoints, NamesLeadNowhere) {
  const auto points = designed_points({.over = {"a/../../x=..,/etc,\"../../../y\""}});
  ASSERT_EQ(points.size(), 3U);
  for (const SweepPoint& point : points) {
    EXPECT_EQ(point.name.find('/'), std::string::npos) << point.name;
    EXPECT_EQ(point.name.substr(0, 3), "000");
  }
  EXPECT_EQ(designed_points({.over = {"slider.start[0]=1 mm"}})[0].name, "0001_start[0]=1mm");
}

TEST(SweepPoints, AreCountedBeforeTheyAreMade) {
  EXPECT_THROW(designed_points({.over = {"a=1:2"}, .samples = 1'000'000'000'000'000'000}),
               UserError);
  EXPECT_THROW(designed_points({.over = std::vector<std::string>(5000, "a=1:2"), .samples = 2}),
               UserError);
  EXPECT_THROW(designed_points({}), UserError);
  std::vector<std::string> over{"x=1:1:100000"};
  for (int i = 0; i < 900; ++i) {
    over.push_back("k" + std::to_string(i) + "=1");
  }
  EXPECT_THROW(designed_points({.over = over}), UserError) << "90 million values";
  EXPECT_THROW(
      designed_points({.over = {"t=\"" + std::string(100'000, 'x') + "\"", "x=1:1:100000"}}),
      UserError)
      << "10 GB";
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
