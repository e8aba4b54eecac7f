// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/path/find_footprint.hpp"
#include "ionskin/mechanics/path/first_touch.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/mechanics/solve_contact.hpp"
#include "small_case.hpp"

#include <gtest/gtest.h>

#include <string>

namespace ionskin::mechanics {
namespace {

Case small_finger() {
  Case input = small_case();
  input.slider.shape = "sphere";
  input.slider.parameters["radius"] = 4e-3;
  input.slider.size = {8e-3, 8e-3};
  input.motion.stroke = 0;
  return input;
}

/// A finger on coarse cells, which serve where no figure is asked for.
Case coarse_finger() {
  Case input = small_finger();
  input.numerics.mesh_refinement = 0.3;
  return input;
}

TEST(FindFootprint, OfASharpSliderIsItsPlan) {
  const mesh::Footprint footprint = find_footprint(small_case(), 0.3, 1).footprint;
  EXPECT_EQ(footprint.half_size, (std::array<double, 2>{0.5e-3, 0.4e-3}));
  EXPECT_TRUE(footprint.sharp(0) && footprint.sharp(1));
}

TEST(FindFootprint, OfASphereHoldsItsContactClosely) {
  const mesh::Footprint footprint = find_footprint(small_finger(), 0.3, 1).footprint;
  EXPECT_TRUE(footprint.round(0) && footprint.round(1));
  const mesh::Footprint largest = mesh::largest_footprint(small_finger());
  for (std::size_t d = 0; d < 2; ++d) {
    EXPECT_LT(footprint.half_size[d], 1.2 * largest.half_size[d]);
    EXPECT_GT(footprint.half_size[d], 0.25 * largest.half_size[d]);
  }
}

TEST(FindFootprint, OfASphereOnFewCellsIsFound) {
  // Four cells across: two widths could follow each other without end, one reached, one ill filled.
  const mesh::Footprint finer = find_footprint(small_finger(), 0.3, 1).footprint;
  for (const double refinement : {0.25, 0.3}) {
    Case input = small_finger();
    input.numerics.mesh_refinement = refinement;
    const mesh::Footprint footprint = find_footprint(input, 0.3, 1).footprint;
    for (std::size_t d = 0; d < 2; ++d) {
      EXPECT_GT(footprint.half_size[d], 0.9 * finer.half_size[d]) << refinement;
      EXPECT_LT(footprint.half_size[d], 2.5 * finer.half_size[d]) << refinement;
    }
  }
}

TEST(FindFootprint, OfABarelyPressedRoundedSliderEndsCloseToItsFlatPart) {
  Case input = small_case();
  input.slider.parameters["edge_radius"] = 0.2e-3;
  input.motion.preload = 0;
  input.motion.preload_force = 0.1;
  const mesh::Footprint footprint = find_footprint(input, 0.3, 1).footprint;
  for (std::size_t d = 0; d < 2; ++d) {
    EXPECT_NEAR(footprint.half_size[d] - footprint.rim[d], input.slider.flat_half_size()[d], 1e-15);
    EXPECT_GT(footprint.rim[d], 0);
    EXPECT_LT(footprint.rim[d], 0.06e-3);
  }
}

TEST(FindFootprint, DoesNotDependOnTheNumberOfThreads) {
  Case input = coarse_finger();
  input.motion.stroke = 1e-3;
  const mesh::Footprint one = find_footprint(input, 0.3, 1).footprint,
                        two = find_footprint(input, 0.3, 2).footprint;
  EXPECT_EQ(one.half_size, two.half_size);
  EXPECT_EQ(one.rim, two.rim);
}

TEST(FindFootprint, IsSharedByAllCoefficientsUpToTheNextStep) {
  EXPECT_EQ(footprint_friction(0), 0);
  EXPECT_EQ(footprint_friction(0.05), 0.5);
  EXPECT_EQ(footprint_friction(0.5), 0.5);
  EXPECT_EQ(footprint_friction(0.51), 1);
  EXPECT_EQ(footprint_friction(2), 2);
  const Case input = coarse_finger();
  EXPECT_EQ(find_footprint(input, 0.1, 1).footprint.half_size,
            find_footprint(input, 0.45, 1).footprint.half_size);
}

TEST(FindFootprint, RefusesAContactOverTheEdgeOfTheSkin) {
  Case input = coarse_finger();
  input.slider.start[0] = 20e-6;
  EXPECT_THROW(find_footprint(input, 0.3, 1), UserError);
}

TEST(FindFootprint, IsNotWidenedOverTheEdgeOfTheSkin) {
  Case input = coarse_finger();
  input.slider.start[0] = 20e-6;
  // The options leave out the search: the contact of the solution itself reaches the end of the
  // skin.
  ContactOptions options;
  options.footprint = mesh::largest_footprint(input);
  base::Timers timers;
  try {
    solve_contact(input, options, timers);
    ADD_FAILURE() << "the contact at the edge was accepted";
  } catch (const UserError& error) {
    EXPECT_NE(std::string(error.what()).find("reaches the edge of the skin along x"),
              std::string::npos)
        << error.what();
  }
}

/// A wedge with its ridge along y at the given place.
Case small_wedge(double ridge) {
  Case input = small_case();
  input.slider.shape = "profile";
  input.slider.profile_heights = {
      {-0.5e-3, ridge, 0.5e-3}, {-0.4e-3, 0.4e-3}, {0.1e-3, 0, 0.1e-3, 0.1e-3, 0, 0.1e-3}};
  return input;
}

TEST(FindFootprint, OfAWedgeFollowsItsRidge) {
  const mesh::Footprint largest = mesh::largest_footprint(small_wedge(0));
  // It indents by 1 um and rises by 0.1 mm over half its size.
  EXPECT_NEAR(largest.half_size[0], 1.15 * 5e-6, 1e-9);
  EXPECT_NEAR(largest.half_size[1], 0.4e-3, 1e-9);
}

/// A height map of a small block: its face is flat, or falls along y only.
/// @param fall height of the side at y > 0 over the other one [m]
Case small_map(double fall) {
  Case input = small_case();
  input.slider.shape = "profile";
  input.slider.profile_heights = {{-0.5e-3, 0.5e-3}, {-0.4e-3, 0.4e-3}, {0, 0, fall, fall}};
  return input;
}

TEST(FindFootprint, OfAMapThatTouchesAtItsBorderEndsThereSharply) {
  const mesh::Footprint flat = find_footprint(small_map(0), 0.3, 1).footprint;
  EXPECT_EQ(flat.half_size, (std::array{0.5e-3, 0.4e-3}));
  EXPECT_TRUE(flat.sharp(0) && flat.sharp(1));
  // Cells further in are those of a contact that may end anywhere.
  EXPECT_EQ(flat.resolved, flat.half_size);
  // Indented by 1 um, it touches at one side along y.
  const mesh::Footprint inclined = find_footprint(small_map(5e-6), 0.3, 1).footprint;
  EXPECT_TRUE(inclined.sharp(0) && inclined.sharp(1));
  const mesh::Footprint wedge = find_footprint(small_wedge(0), 0.3, 1).footprint;
  EXPECT_TRUE(wedge.round(0) && wedge.sharp(1));
}

TEST(FindFootprint, OfAMapAtAnAngleHasNoRowsOfCellsAlongItsBorder) {
  Case input = small_map(0);
  input.slider.pose.yaw = 0.3;
  input.motion.stroke = 0;
  const mesh::Footprint footprint = find_footprint(input, 0.3, 1).footprint;
  EXPECT_TRUE(footprint.round(0) && footprint.round(1));
}

TEST(FindFootprint, OfAdhesionOverAWideGapIsFound) {
  Case input = small_wedge(0);
  input.motion.stroke = 0;
  input.motion.preload = 0.1e-6;
  input.numerics.mesh_refinement = 0.3;
  input.contact.law = "adhesive";
  input.contact.parameters = {{"work_of_adhesion", 1.0}, {"cohesive_strength", 1e4}};
  // It pulls over 0.1 mm, a thousand times what it is pressed in.
  EXPECT_GT(find_footprint(input, 0.3, 1).footprint.half_size[0],
            100 * mesh::largest_footprint(input).half_size[0]);
}

TEST(FirstTouch, RefusesASliderThatTouchesNoCell) {
  EXPECT_NO_THROW(require_touch(small_wedge(0)));
  Case input = small_wedge(0.3e-3); // far from the centre, where cells are wide
  input.motion.preload = 1e-9;
  EXPECT_THROW(require_touch(input), UserError);
  EXPECT_THROW(find_footprint(input, 0.3, 1), UserError);
}

TEST(FirstTouch, RefusesAPathAboveTheSkin) {
  Case input = small_case();
  input.motion.kind = MotionKind::waypoints;
  input.motion.waypoints = {{0, {1.5e-3, 1e-3}, 1e-3, {}, 0}, {1, {2e-3, 1e-3}, 1e-4, {}, 0}};
  EXPECT_THROW(require_touch(input), UserError);
}

} // namespace
} // namespace ionskin::mechanics
