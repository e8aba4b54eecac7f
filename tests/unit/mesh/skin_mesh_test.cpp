// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mesh/skin_mesh.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/mesh/mesh_resolution.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace ionskin::mesh {
namespace {

Case example() {
  Case input;
  const Material metal{"metal", 100e9, 0.3}, polymer{"polymer", 250e6, 0.49};
  input.skin.length = 15e-3;
  input.skin.width = 2e-3;
  input.skin.layers = {{"lower", LayerRole::electrode, metal, 10e-6},
                       {"core", LayerRole::core, polymer, 180e-6},
                       {"inner", LayerRole::electrode, metal, 5e-6},
                       {"upper", LayerRole::electrode, metal, 10e-6}};
  input.slider.size = {3e-3, 1.5e-3};
  input.slider.start = {4.5e-3, 1e-3};
  input.motion.stroke = 6e-3;
  input.numerics.preset = Preset::coarse;
  return input;
}

void expect_ascending(const std::vector<double>& line, double end) {
  EXPECT_EQ(line.front(), 0.0);
  EXPECT_DOUBLE_EQ(line.back(), end);
  EXPECT_TRUE(std::is_sorted(line.begin(), line.end(), std::less_equal<>()));
}

TEST(Footprint, IsExpectedAtTheEdgeOfTheSkinUnderAHeavyLoadAlone) {
  Case input = example();
  input.slider.shape = "sphere";
  input.slider.parameters = {{"radius", 20e-3}};
  input.slider.size = {8e-3, 8e-3};
  for (const auto& [force, at_edge] : {std::pair{0.01, false}, {50.0, true}}) {
    input.motion.preload_force = force;
    const Footprint footprint = expected_footprint(input);
    EXPECT_EQ(ends_at_skin(input, footprint, 1), at_edge) << force; // 1 mm to either side
    EXPECT_FALSE(ends_at_skin(input, footprint, 0)) << force;
  }
  input.slider.size = {1.5e-3, 1.5e-3}; // the slider ends before the skin does
  EXPECT_FALSE(ends_at_skin(input, expected_footprint(input), 1));
  EXPECT_FALSE(ends_at_skin(example(), expected_footprint(example()), 1)); // sharp
}

TEST(MeshResolution, OfATiltingSliderIsThatOfItsUprightContact) {
  const Case input = example();
  Footprint footprint{{0.5e-3, 0.5e-3}, {0.5e-3, 0.5e-3}, {}};
  const auto size = [&](double resolved) {
    footprint.resolved = {resolved, resolved};
    return mesh_resolution(input, footprint).edge_size[0];
  };
  const double whole = size(0);
  EXPECT_DOUBLE_EQ(size(0.35e-3), 0.7 * whole);
  EXPECT_DOUBLE_EQ(size(0.1e-3), 0.5 * whole); // else the cells of a steep tilt would be too many
  EXPECT_DOUBLE_EQ(size(0.8e-3), whole);
}

TEST(MeshResolution, OfARoundContactThatEndsSharplyIsFineThroughout) {
  const Case input = example();
  const Footprint flat = largest_footprint(input);
  Footprint round = flat;
  round.rim = round.half_size;
  Footprint both = round;
  for (const std::size_t d : {0, 1}) {
    both.end_sharply(d);
  }
  const MeshResolution edges = mesh_resolution(input, flat), rim = mesh_resolution(input, round),
                       found = mesh_resolution(input, both);
  EXPECT_EQ(found.edge_size, edges.edge_size);
  EXPECT_EQ(found.footprint_largest[0], rim.edge_size[0]);
  EXPECT_LT(found.footprint_largest[0], edges.footprint_largest[0]);
  const std::vector<double> lines = SkinMesh(input, both).footprint_lines_x();
  double widest = 0;
  for (std::size_t i = 1; i < lines.size(); ++i) {
    widest = std::max(widest, lines[i] - lines[i - 1]);
  }
  EXPECT_LE(widest, rim.edge_size[0]);
  EXPECT_LE(lines[1] - lines[0], edges.edge_size[0]);
}

/// A slider on a drive leaves its path.
TEST(SkinMesh, LinesAscendWhereverTheSliderSwings) {
  const SkinMesh mesh(example());
  for (const double left : {2e-5, 1e-4, 1e-3}) {
    for (const double x : {1.5e-3 + left, 13.5e-3 - left}) {
      const MeshLines lines = mesh.lines({x, 1e-3});
      expect_ascending(lines.x, 15e-3);
      EXPECT_EQ(lines.x.size(), mesh.lines({4.5e-3, 1e-3}).x.size());
    }
  }
}

TEST(SkinMesh, TopologyDoesNotDependOnThePosition) {
  const SkinMesh mesh(example());
  for (int i = 0; i <= 20; ++i) {
    const double x = 4.5e-3 + 6e-3 * i / 20;
    const MeshLines lines = mesh.lines({x, 1e-3});
    expect_ascending(lines.x, 15e-3);
    expect_ascending(lines.y, 1e-3);
    expect_ascending(lines.z, 205e-6);
    ASSERT_EQ(lines.x.size(), mesh.elements()[0] + 1);
    ASSERT_EQ(lines.y.size(), mesh.elements()[1] + 1);
    EXPECT_NEAR(lines.x[mesh.footprint_x()[0]], x - 1.5e-3, 1e-15);
    EXPECT_NEAR(lines.x[mesh.footprint_x()[1]], x + 1.5e-3, 1e-15);
    EXPECT_NEAR(lines.y[mesh.footprint_y()[0]], 0.25e-3, 1e-15);
  }
}

TEST(SkinMesh, LinesMoveSmoothlyWithThePosition) {
  const SkinMesh mesh(example());
  const auto second_difference = [&](std::size_t line, double step) {
    const auto at = [&](double x) { return mesh.lines({x, 1e-3}).x[line]; };
    return at(6e-3 + step) - 2 * at(6e-3) + at(6e-3 - step);
  };
  for (std::size_t line = 1; line < mesh.footprint_x()[0]; ++line) {
    EXPECT_LT(std::abs(second_difference(line, 1e-5)), 1e-8) << line;
  }
}

TEST(SkinMesh, MirroredPositionsHaveMirroredLines) {
  Case input = example();
  input.slider.start[1] = 0.9e-3;
  const SkinMesh mesh(input);
  const MeshLines lines = mesh.lines({5e-3, 0.9e-3}), mirror = mesh.lines({10e-3, 1.1e-3});
  for (std::size_t i = 0; i < lines.x.size(); ++i) {
    EXPECT_NEAR(lines.x[i], 15e-3 - mirror.x[lines.x.size() - 1 - i], 1e-15);
  }
  for (std::size_t j = 0; j < lines.y.size(); ++j) {
    EXPECT_NEAR(lines.y[j], 2e-3 - mirror.y[lines.y.size() - 1 - j], 1e-15);
  }
}

TEST(SkinMesh, HalfModelOnlyOnTheSymmetryPlane) {
  Case input = example();
  EXPECT_TRUE(SkinMesh(input).half_model());
  input.slider.start[1] = 0.9e-3;
  EXPECT_FALSE(SkinMesh(input).half_model());
  input = example();
  input.motion.direction = {std::sqrt(0.5), std::sqrt(0.5)};
  input.motion.stroke = 0.2e-3;
  EXPECT_FALSE(SkinMesh(input).half_model());
}

TEST(SkinMesh, LayersAreData) {
  const SkinMesh mesh(example());
  const auto [first, last] = mesh.core_z();
  EXPECT_EQ(first, 1u);
  EXPECT_EQ(mesh.elements()[2], last + 2);
  for (std::size_t row = 0; row < mesh.layer_of_row().size(); ++row) {
    EXPECT_EQ(mesh.layer_of_row()[row] == 1, row >= first && row < last);
  }
}

/// Element sizes between the side and the footprint, from the side inwards.
std::vector<double> sizes_beside(const SkinMesh& mesh, std::size_t direction) {
  const MeshLines lines = mesh.lines({4.5e-3, 1e-3});
  const std::vector<double>& line = direction == 0 ? lines.x : lines.y;
  const std::size_t count = direction == 0 ? mesh.footprint_x()[0] : mesh.footprint_y()[0];
  std::vector<double> sizes;
  for (std::size_t i = 0; i < count; ++i) {
    sizes.push_back(line[i + 1] - line[i]);
  }
  return sizes;
}

TEST(SkinMesh, ElementsShrinkTowardsFreeFacesNearAndFar) {
  Case input = example();
  input.numerics.preset = Preset::fine;
  const auto side = sizes_beside(SkinMesh(input), 1), end = sizes_beside(SkinMesh(input), 0);
  for (const auto& sizes : {side, end}) { // the ends are 15 thicknesses away
    const auto largest = std::max_element(sizes.begin(), sizes.end());
    EXPECT_LT(sizes.front(), 0.5 * *largest);
    EXPECT_LT(sizes.back(), 0.5 * *largest);
    EXPECT_TRUE(std::is_sorted(sizes.begin(), largest));
  }
  EXPECT_LT(end.front(), 0.25 * input.skin.thickness());
}

TEST(SkinMesh, FineElementsStaySmallWhereContactBeginsAgainInsideASharpEdge) {
  Case input = example();
  input.numerics.preset = Preset::fine;
  const double thickness = input.skin.thickness();
  const SkinMesh mesh(input);
  for (const auto* line : {&mesh.footprint_lines_x(), &mesh.footprint_lines_y()}) {
    for (std::size_t i = 0; (*line)[i] - line->front() < 0.45 * thickness; ++i) {
      EXPECT_LE((*line)[i + 1] - (*line)[i], thickness / 8) << i;
    }
  }
}

TEST(SkinMesh, ElementsDoNotShrinkTowardsAPlaneOfSymmetry) {
  Case input = example();
  input.numerics.preset = Preset::fine;
  input.skin.sides = SideCondition::symmetry;
  const auto side = sizes_beside(SkinMesh(input), 1);
  EXPECT_TRUE(std::is_sorted(side.rbegin(), side.rend()));
}

TEST(SkinMesh, PlaneStrainNeedsOneElementAcross) {
  Case input = example();
  input.skin.sides = SideCondition::symmetry;
  input.slider.size[1] = 5e-3;
  const SkinMesh mesh(input);
  EXPECT_EQ(mesh.elements()[1], 1u);
  EXPECT_EQ(mesh.footprint_y()[1] - mesh.footprint_y()[0], 1u);
}

TEST(SkinMesh, RefinementMultipliesTheCounts) {
  Case input = example();
  const auto before = SkinMesh(input).elements();
  input.numerics.mesh_refinement = 2;
  const auto after = SkinMesh(input).elements();
  for (int d = 0; d < 3; ++d) {
    EXPECT_NEAR(static_cast<double>(after[d]) / static_cast<double>(before[d]), 2.0, 0.35);
  }
}

TEST(SkinMesh, RefusesASliderAtTheEdgeOfTheSkin) {
  Case input = example();
  input.slider.start[0] = 1.5e-3;
  EXPECT_THROW(SkinMesh{input}, UserError);
}

TEST(SkinMesh, ARoundContactHasAUniformFootprint) {
  Case input = example();
  input.slider.shape = "sphere";
  input.slider.parameters["radius"] = 8e-3;
  input.slider.size = {16e-3, 16e-3};
  const SkinMesh mesh(input, {{0.4e-3, 0.3e-3}, {0.4e-3, 0.3e-3}});
  const std::vector<double>& x = mesh.footprint_lines_x();
  EXPECT_EQ(x.front(), -0.4e-3);
  EXPECT_NEAR(x.back(), 0.4e-3, 1e-18);
  for (std::size_t i = 2; i < x.size(); ++i) {
    EXPECT_NEAR(x[i] - x[i - 1], x[1] - x[0], 1e-15);
  }
  EXPECT_TRUE(mesh.half_model());
}

TEST(SkinMesh, ARoundedEdgeHasARimOfEqualElementsBeforeLargerOnes) {
  Case input = example();
  input.slider.parameters["edge_radius"] = 0.5e-3;
  const SkinMesh mesh(input, {{1.24e-3, 0.49e-3}, {0.24e-3, 0.24e-3}});
  const std::vector<double>& x = mesh.footprint_lines_x();
  for (std::size_t i = 1; i <= 8; ++i) {
    EXPECT_NEAR(x[i] - x[i - 1], 0.03e-3, 1e-15);
  }
  EXPECT_GT(x[x.size() / 2] - x[x.size() / 2 - 1], 5 * (x[1] - x[0]));
}

TEST(SkinMesh, ANarrowRimIsNoFinerThanASharpEdge) {
  Case input = example();
  const std::size_t sharp = SkinMesh(input).elements()[0];
  input.slider.parameters["edge_radius"] = 0.1e-3;
  const SkinMesh mesh(input, {{1.403e-3, 0.653e-3}, {0.003e-3, 0.003e-3}});
  EXPECT_LE(mesh.elements()[0], sharp + 2);
}

TEST(SkinMesh, ALineContactIsAsCoarseAlongItAsItsLengthAllows) {
  Case input = example();
  input.slider.shape = "cylinder";
  input.slider.parameters["radius"] = 8e-3;
  const SkinMesh narrow(input, {{0.02e-3, 0.75e-3}, {0.02e-3, 0}});
  const SkinMesh wide(input, {{0.2e-3, 0.75e-3}, {0.2e-3, 0}});
  EXPECT_LE(narrow.elements()[1], wide.elements()[1] + 10);
}

TEST(SkinMesh, ADeepBlockIsGradedDownwardsAndAThinSkinIsNot) {
  Case input = example();
  const std::vector<double> thin = SkinMesh(input).lines({4.5e-3, 1e-3}).z;
  EXPECT_EQ(thin.size(), 6u);
  input.skin.layers[1].thickness = 5e-3;
  const SkinMesh deep(input);
  const std::vector<double> z = deep.lines({4.5e-3, 1e-3}).z;
  expect_ascending(z, 5.025e-3);
  EXPECT_GT(deep.core_z()[1] - deep.core_z()[0], 3u);
  // Sizes within the core fall upwards.
  for (std::size_t row = deep.core_z()[0] + 1; row < deep.core_z()[1]; ++row) {
    EXPECT_LT(z[row + 1] - z[row], z[row] - z[row - 1]);
  }
}

TEST(SkinMesh, ALineLiesAtHalfTheHeightOfTheCore) {
  Case input = example();
  for (const Preset preset : {Preset::coarse, Preset::standard, Preset::fine}) {
    for (const double refinement : {0.25, 0.5, 0.6, 1.0, 1.3, 1.7, 2.0}) {
      input.numerics.preset = preset;
      input.numerics.mesh_refinement = refinement;
      const SkinMesh mesh(input);
      const std::vector<double> z = mesh.lines({4.5e-3, 1e-3}).z;
      const auto [first, last] = mesh.core_z();
      ASSERT_EQ((last - first) % 2, 0u);
      EXPECT_NEAR(z[(first + last) / 2], 0.5 * (z[first] + z[last]), 1e-15);
    }
  }
}

TEST(Footprint, BoundsFollowShapeAndLoad) {
  Case input = example();
  input.slider.shape = "sphere";
  input.slider.parameters["radius"] = 8e-3;
  input.slider.size = {16e-3, 16e-3};
  input.motion.preload = 1e-6;
  EXPECT_NEAR(largest_footprint(input).half_size[0], 1.15 * 2 * std::sqrt(8e-9), 1e-12);
  input.motion.preload = 0;
  input.motion.preload_force = 1;
  const double modulus = 250e6 / (1 - 0.49 * 0.49);
  EXPECT_NEAR(largest_footprint(input).half_size[0], 1.15 * std::cbrt(0.75 * 8e-3 / modulus),
              1e-12);
  input.slider.start[1] = 0.1e-3;
  EXPECT_LT(largest_footprint(input).half_size[1], 0.1e-3);
}

TEST(Footprint, BoundFollowsTheStiffnessOfTheSlider) {
  Case input = example();
  input.slider.shape = "sphere";
  input.slider.parameters["radius"] = 8e-3;
  input.slider.size = {16e-3, 16e-3};
  input.slider.poissons_ratio = 0.49;
  input.motion.preload = 0;
  input.motion.preload_force = 1e-3;
  const double of_skin = 250e6 / (1 - 0.49 * 0.49);
  for (const double modulus : {1e5, 1e6, 1e7, 1e8, 1e9, 1e12}) { // Hertz's contact of two bodies
    input.slider.youngs_modulus = modulus;
    const double common = 1 / (1 / of_skin + (1 - 0.49 * 0.49) / modulus);
    EXPECT_NEAR(largest_footprint(input).half_size[0],
                1.15 * std::cbrt(0.75 * 1e-3 * 8e-3 / common), 1e-12)
        << modulus;
  }
}

} // namespace
} // namespace ionskin::mesh
