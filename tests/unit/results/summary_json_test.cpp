// SPDX-License-Identifier: Apache-2.0
#include "ionskin/results/summary_json.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>

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

} // namespace
} // namespace ionskin::results
