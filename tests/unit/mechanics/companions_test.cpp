// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/companions.hpp"

#include "ionskin/mesh/mesh_resolution.hpp"

#include <gtest/gtest.h>

namespace ionskin::mechanics {
namespace {

TEST(Companions, have_twice_the_mesh_sizes) {
  Case input;
  input.numerics.mesh_refinement = 1.4;
  for (const char* name : {companions::mesh, companions::path, companions::thickness}) {
    EXPECT_DOUBLE_EQ(companion_case(input, name).numerics.mesh_refinement, 0.7);
  }
  EXPECT_EQ(companion_case(input, companions::mesh).numerics.time_refinement, 1);
  EXPECT_EQ(companion_case(input, companions::path).numerics.time_refinement, 0.5);
}

TEST(Companions, one_has_more_layers_where_the_others_cannot_have_fewer) {
  Case input;
  input.numerics.preset = Preset::coarse;
  ASSERT_TRUE(needs_thickness_companion(input));
  EXPECT_EQ(mesh::core_elements(companion_case(input, companions::thickness).numerics),
            2 * mesh::core_elements(companion_case(input, companions::mesh).numerics));
  input.numerics.preset = Preset::standard;
  EXPECT_FALSE(needs_thickness_companion(input));
}

} // namespace
} // namespace ionskin::mechanics
