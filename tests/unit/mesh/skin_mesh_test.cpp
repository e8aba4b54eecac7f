// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mesh/skin_mesh.hpp"

#include "ionskin/base/error.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

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

TEST(SkinMesh, topology_does_not_depend_on_the_position) {
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

TEST(SkinMesh, lines_move_smoothly_with_the_position) {
  const SkinMesh mesh(example());
  const auto second_difference = [&](std::size_t line, double step) {
    const auto at = [&](double x) { return mesh.lines({x, 1e-3}).x[line]; };
    return at(6e-3 + step) - 2 * at(6e-3) + at(6e-3 - step);
  };
  for (std::size_t line = 1; line < mesh.footprint_x()[0]; ++line) {
    EXPECT_LT(std::abs(second_difference(line, 1e-5)), 1e-8) << line;
  }
}

TEST(SkinMesh, mirrored_positions_have_mirrored_lines) {
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

TEST(SkinMesh, half_model_only_on_the_symmetry_plane) {
  Case input = example();
  EXPECT_TRUE(SkinMesh(input).half_model());
  input.slider.start[1] = 0.9e-3;
  EXPECT_FALSE(SkinMesh(input).half_model());
  input = example();
  input.motion.direction = {std::sqrt(0.5), std::sqrt(0.5)};
  input.motion.stroke = 0.2e-3;
  EXPECT_FALSE(SkinMesh(input).half_model());
}

TEST(SkinMesh, layers_are_data) {
  const SkinMesh mesh(example());
  const auto [first, last] = mesh.core_z();
  EXPECT_EQ(first, 1u);
  EXPECT_EQ(mesh.elements()[2], last + 2);
  for (std::size_t row = 0; row < mesh.layer_of_row().size(); ++row) {
    EXPECT_EQ(mesh.layer_of_row()[row] == 1, row >= first && row < last);
  }
}

TEST(SkinMesh, plane_strain_needs_one_element_across) {
  Case input = example();
  input.skin.sides = SideCondition::symmetry;
  input.slider.size[1] = 5e-3;
  const SkinMesh mesh(input);
  EXPECT_EQ(mesh.elements()[1], 1u);
  EXPECT_EQ(mesh.footprint_y()[1] - mesh.footprint_y()[0], 1u);
}

TEST(SkinMesh, refinement_multiplies_the_counts) {
  Case input = example();
  const auto before = SkinMesh(input).elements();
  input.numerics.mesh_refinement = 2;
  const auto after = SkinMesh(input).elements();
  for (int d = 0; d < 3; ++d) {
    EXPECT_NEAR(static_cast<double>(after[d]) / static_cast<double>(before[d]), 2.0, 0.35);
  }
}

TEST(SkinMesh, refuses_a_slider_at_the_edge_of_the_skin) {
  Case input = example();
  input.slider.start[0] = 1.5e-3;
  EXPECT_THROW(SkinMesh{input}, UserError);
}

} // namespace
} // namespace ionskin::mesh
