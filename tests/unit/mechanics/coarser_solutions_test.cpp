// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/coarser_solutions.hpp"

#include "ionskin/mesh/mesh_resolution.hpp"

#include <gtest/gtest.h>

namespace ionskin::mechanics {
namespace {

TEST(CoarserSolutions, HaveTwiceTheMeshSizes) {
  Case input;
  input.numerics.mesh_refinement = 1.4;
  for (const char* name :
       {coarser_solutions::mesh, coarser_solutions::path, coarser_solutions::thickness}) {
    EXPECT_DOUBLE_EQ(coarser_case(input, name).numerics.mesh_refinement, 0.7);
  }
  EXPECT_EQ(coarser_case(input, coarser_solutions::mesh).numerics.time_refinement, 1);
  EXPECT_EQ(coarser_case(input, coarser_solutions::path).numerics.time_refinement, 0.5);
}

TEST(CoarserSolutions, OneHasMoreLayersWhereTheOthersCannotHaveFewer) {
  Case input;
  input.numerics.preset = Preset::coarse;
  ASSERT_TRUE(needs_coarser_thickness(input));
  EXPECT_EQ(mesh::core_elements(coarser_case(input, coarser_solutions::thickness).numerics),
            2 * mesh::core_elements(coarser_case(input, coarser_solutions::mesh).numerics));
  input.numerics.preset = Preset::standard;
  EXPECT_FALSE(needs_coarser_thickness(input));
}

} // namespace
} // namespace ionskin::mechanics
