// SPDX-License-Identifier: Apache-2.0
#include "ionskin/planning/resources.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/case/reading/read_case.hpp"
#include "ionskin/mechanics/surface/contact_cells.hpp"
#include "ionskin/mesh/skin_mesh.hpp"
#include "ionskin/planning/cost_estimate.hpp"
#include "ionskin/planning/output_size.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

namespace ionskin::planning {
namespace {

Case quick(const std::vector<std::string>& edits = {}) {
  return read_case(IONSKIN_CASES "/paper/coarse.toml", edits);
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

TEST(Resources, AreNotThereForFilesThatTheDiskDoesNotHold) {
  Case input = quick();
  input.output.fields.assign(10'000, 0.6);
  const double bytes = expected_output(input, true);
  EXPECT_NEAR(bytes, 5.5e9, 1.5e9);
  EXPECT_LT(expected_output(input, false), 20e6) << "the mechanics keeps no fields";
  EXPECT_THROW(require_disk(1e19, "/no/such/folder"), UserError);
  EXPECT_NO_THROW(require_disk(1, "/no/such/folder"));
  setenv("IONSKIN_DISK_LIMIT", "1 GB", 1);
  try {
    require_disk(bytes, ".");
    ADD_FAILURE();
  } catch (const UserError& error) {
    EXPECT_THAT(error.what(),
                testing::HasSubstr("GB, and 1.0 GB are allowed by IONSKIN_DISK_LIMIT"));
    EXPECT_THAT(error.what(), testing::HasSubstr("fewer instants in output.fields"));
  }
  EXPECT_NO_THROW(require_disk(0.9e9, "."));
  setenv("IONSKIN_DISK_LIMIT", "much", 1);
  EXPECT_THROW(require_disk(1, "."), UserError);
  unsetenv("IONSKIN_DISK_LIMIT");
}

TEST(AnnouncedTime, TellsLongRunsAndWhatTakesLess) {
  Case input = quick();
  CostEstimate cost;
  cost.seconds = 200;
  EXPECT_EQ(announced_time(input, cost), "");
  cost.seconds = 3300;
  EXPECT_EQ(announced_time(input, cost),
            "the run will take about 55 min; a smaller numerics.mesh_refinement takes less");
  input.numerics.preset = Preset::standard;
  EXPECT_THAT(announced_time(input, cost), testing::HasSubstr("numerics.preset = \"coarse\""));
  cost.seconds = 90'000;
  EXPECT_THAT(announced_time(input, cost), testing::HasSubstr("about 25 h;"));
  input.motion.waypoints.resize(3000);
  EXPECT_THAT(announced_time(input, cost), testing::HasSubstr("has 3000 rows"));
}

TEST(OutputSize, GrowsWithFieldsReadingsAndTaxels) {
  Case input = quick();
  const double plain = estimate_cost(input, 2).output;
  EXPECT_GT(plain, 1e6); // cases/paper/coarse.toml writes 6 MB at coarse
  EXPECT_LT(plain, 20e6);
  EXPECT_EQ(announced_output(input, plain), "");
  input.output.fields.assign(10'000, 0.6);
  const double fields = estimate_cost(input, 2).output;
  EXPECT_NEAR(fields, 5.5e9, 1.5e9); // of half a megabyte each
  EXPECT_THAT(announced_output(input, fields), testing::HasSubstr("output.fields: 10000"));
  input.output.fields.clear();
  input.readout.sample_interval = 2e-6; // two million readings
  EXPECT_NEAR(estimate_cost(input, 2).output, 0.4e9, 0.2e9);
  input.readout.taxels.assign(16, {"one", {0, 0}, {1e-3, 1e-3}});
  EXPECT_NEAR(estimate_cost(input, 2).output, 3e9, 1.5e9);
}

TEST(Resources, OfThinFilmsAreRefusedBeforeTheyAreBuilt) {
  const Case films = quick({"skin.layers[0].thickness=200 nm", "skin.layers[1].thickness=200 nm",
                            "skin.layers[2].thickness=200 nm", "motion.preload=1 nm"});
  EXPECT_THROW(require_resources(films, 2), UserError);
}

TEST(Resources, OfAContactThatWasFoundFollowFromItsCells) {
  const Case ball = quick({"slider.shape=sphere", "slider.radius=4 mm"});
  mesh::Footprint small = mesh::largest_footprint(ball);
  for (std::size_t d = 0; d < 2; ++d) {
    small.half_size[d] *= 0.4;
    small.rim[d] *= 0.4;
  }
  const CostEstimate found = estimate_cost(ball, 2, small);
  const mesh::SkinMesh mesh(ball, small);
  EXPECT_EQ(found.contact_cells, mechanics::contact_cells(mesh).count());
}

TEST(Resources, StepsWithoutEndAreRefused) {
  EXPECT_THROW(
      require_resources(quick({"motion.slide=10000000 s", "electrochemistry.diffusivity=1e-4 m2/s",
                               "numerics.time_refinement=100", "numerics.time_tolerance=1e-12",
                               "readout.sample_interval=100 s", "output.fields=[]"}),
                        2),
      UserError);
}

} // namespace
} // namespace ionskin::planning
