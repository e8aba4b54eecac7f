// SPDX-License-Identifier: Apache-2.0
#include "ionskin/results/summary_json.hpp"

#include "ionskin/base/error.hpp"
#include "scratch_folder.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <filesystem>
#include <sys/stat.h>

namespace ionskin::results {
namespace {

TEST(SummaryJson, HoldsMetricsTimingWarningsAndErrorEstimates) {
  Summary summary;
  summary.metrics = {{"normal_force_slide", 65.25, "N"}, {"nonlinearity", NAN, "1"}};
  summary.timing = {{"total", 12.5}};
  summary.warnings = {"the coupling is \"uncalibrated\""};
  summary.error_estimate = {{"normal_force_slide", 0.004}};
  summary.error_parts = {{"normal_force_slide", {{"mechanics_mesh", 0.2}, {"path", 0.061}}}};
  summary.not_converging = {{"element_max_shear_slide", "a reason"}};
  summary.not_estimated = {{"nonlinearity", "another"}};
  const auto json = nlohmann::json::parse(summary_text(summary));
  EXPECT_EQ(json["metrics"]["normal_force_slide"]["value"], 65.25);
  EXPECT_EQ(json["metrics"]["normal_force_slide"]["unit"], "N");
  EXPECT_TRUE(json["metrics"]["nonlinearity"]["value"].is_null());
  EXPECT_EQ(json["timing"]["total"], 12.5);
  EXPECT_EQ(json["warnings"][0], "the coupling is \"uncalibrated\"");
  EXPECT_EQ(json["error_estimate"]["normal_force_slide"], 0.004);
  EXPECT_EQ(json["error_parts"]["normal_force_slide"]["path"], 0.061);
  EXPECT_EQ(json["not_converging"]["element_max_shear_slide"], "a reason");
  EXPECT_EQ(json["not_estimated"]["nonlinearity"], "another");
}

TEST(SummaryJson, OfNothingHasEveryKey) {
  const auto json = nlohmann::json::parse(summary_text({}));
  EXPECT_TRUE(json["metrics"].is_object());
  EXPECT_TRUE(json["timing"].is_object());
  EXPECT_TRUE(json["warnings"].is_array());
  EXPECT_TRUE(json["error_estimate"].is_object());
  EXPECT_TRUE(json["error_parts"].is_object());
}

TEST(SummaryJson, ReadsBackItsMetrics) {
  const ScratchFolder folder;
  Summary summary;
  summary.metrics = {{"normal_force_slide", 65.25, "N"}, {"nonlinearity", NAN, "1"}};
  summary.warnings = {"a warning"};
  write_summary(folder / "summary.json", summary);
  const Summary read = read_summary(folder / "summary.json");
  ASSERT_EQ(read.metrics.size(), 2U);
  EXPECT_EQ(read.metrics[0].value, 65.25);
  EXPECT_TRUE(std::isnan(read.metrics[1].value));
  EXPECT_EQ(read.warnings, summary.warnings);
}

TEST(SummaryJson, OfAnyTypesAndDepthIsAUserError) {
  const ScratchFolder folder;
  const std::string deep = std::string(1'000'000, '[') + std::string(1'000'000, ']');
  for (const std::string& text :
       {deep, "{\"metrics\": " + deep + "}", std::string("[]"), std::string("{\"metrics\": 3}"),
        std::string("{\"metrics\": [1]}"), std::string("{\"metrics\": {\"a\": 1}}"),
        std::string("{\"metrics\": {\"a\": {\"value\": \"1\", \"unit\": \"N\"}}}"),
        std::string("{\"metrics\": {\"a\": {\"value\": 1, \"unit\": 2}}}"),
        std::string("{\"metrics\": {}, \"warnings\": 3}"),
        std::string("{\"metrics\": {}, \"error_parts\": {\"a\": 1}}")}) {
    write_all(folder / "summary.json", text);
    EXPECT_THROW(read_summary(folder / "summary.json"), UserError) << text.substr(0, 80);
  }
}

TEST(SummaryJson, AFolderAPipeOrADeviceIsNone) {
  const ScratchFolder folder;
  std::filesystem::create_directory(folder / "folder");
  std::filesystem::create_symlink("/dev/zero", folder / "device");
  ASSERT_EQ(mkfifo((folder / "pipe").c_str(), 0600), 0);
  for (const char* name : {"folder", "device", "pipe", "missing"}) {
    EXPECT_THROW(read_summary(folder / name), UserError) << name;
  }
}

} // namespace
} // namespace ionskin::results
