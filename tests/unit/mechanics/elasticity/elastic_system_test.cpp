// SPDX-License-Identifier: Apache-2.0
#include "ionskin/linear_algebra/cholesky.hpp"
#include "ionskin/mechanics/elasticity/core_lattice.hpp"
#include "ionskin/mechanics/elasticity/core_strain.hpp"
#include "ionskin/mechanics/elasticity/elastic_system.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace ionskin::mechanics {
namespace {

const mesh::MeshLines lines{{0, 0.3, 1.0}, {0, 0.5, 0.9}, {0, 0.2, 0.3, 0.7}};
const std::vector<ElasticLaw> uniform(3, isotropic_elasticity({"polymer", 2.0, 0.45}));

/// All faces but the top held in their normal direction, the base wholly: confined compression.
std::vector<FixedFace> oedometer() {
  return {{"base", Face::base, {true, true, true}},
          {"side", Face::x_min, {true, false, false}},
          {"side", Face::x_max, {true, false, false}},
          {"side", Face::y_min, {false, true, false}},
          {"side", Face::y_max, {false, true, false}}};
}

/// Loads of a uniform pressure on the whole top face; Simpson's weights are exact for quadratics.
linear_algebra::DenseMatrix pressure_load(const ElasticSpace& space, double pressure) {
  const auto [nx, ny, nz] = space.elements();
  constexpr std::array<double, 3> weight{1.0 / 6, 4.0 / 6, 1.0 / 6};
  linear_algebra::DenseMatrix load(space.unknowns(), 1);
  for (std::size_t j = 0; j < ny; ++j) {
    for (std::size_t i = 0; i < nx; ++i) {
      const double area = (lines.x[i + 1] - lines.x[i]) * (lines.y[j + 1] - lines.y[j]);
      for (std::size_t a = 0; a < 9; ++a) {
        const int node = space.node_at(2 * i + a % 3, 2 * j + a / 3, 2 * nz);
        load(space.unknown(node)[2], 0) -= pressure * area * weight[a % 3] * weight[a / 3];
      }
    }
  }
  return load;
}

TEST(ElasticSystem, confined_compression_is_exact) {
  const ElasticSpace space(lines, oedometer());
  const ElasticSystem system = assemble(space, lines, uniform);
  const linear_algebra::SymbolicCholesky symbolic(space.pattern(), space.elimination_order({}), 0);
  const auto displacement =
      linear_algebra::Cholesky(symbolic, system.stiffness).solve(pressure_load(space, 0.01));

  const double expected = -0.01 / uniform[0].oedometric_modulus();
  const CoreLattice lattice(space, {0, 3});
  std::vector<double> nodal(static_cast<std::size_t>(lattice.rows()));
  lattice.gather(displacement.column(0), nodal.data());
  const CoreStrain strain = lattice_strain(lines, {0, 3}, nodal.data());
  for (int c = 0; c < 6; ++c) {
    for (const double value : strain.component[c]) {
      EXPECT_NEAR(value, c == 2 ? expected : 0, 1e-12 * std::abs(expected));
    }
  }
  const auto& reaction = system.base_reaction[2];
  const double base =
      std::inner_product(reaction.begin(), reaction.end(), displacement.column(0), 0.0);
  EXPECT_NEAR(base, -0.01 * 0.9, 1e-14); // the skin pushes its base down with the load
}

TEST(ElasticSystem, elimination_order_ends_with_the_trailing_nodes) {
  const ElasticSpace space(lines, oedometer());
  const std::vector<int> top{space.node_at(1, 1, 6), space.node_at(2, 1, 6)};
  const std::vector<int> order = space.elimination_order(top), last = space.unknowns_of(top);
  EXPECT_EQ(order.size(), static_cast<std::size_t>(space.unknowns()));
  EXPECT_TRUE(std::equal(last.rbegin(), last.rend(), order.rbegin()));
}

TEST(CoreStrain, shear_integral_of_a_uniform_field_is_exact) {
  CoreStrain strain;
  strain.points = {4, 4, 2};
  strain.component.fill(std::vector<double>(32, 0.0));
  strain.component[3].assign(32, 0.02);
  strain.component[4].assign(32, -0.03);
  strain.component[5].assign(32, 0.06);
  EXPECT_NEAR(off_diagonal_shear_integral(strain, lines, {1, 2}), 2 * 0.07 * 0.9 * 0.1, 1e-16);
}

TEST(CoreStrain, reflecting_twice_changes_nothing_and_once_turns_the_shear) {
  CoreStrain strain;
  strain.points = {4, 2, 2};
  for (auto& component : strain.component) {
    component.resize(16);
    std::iota(component.begin(), component.end(), 1.0);
  }
  const CoreStrain once = mirrored(strain, {true, false});
  EXPECT_EQ(once.component[0][0], strain.component[0][3]);
  EXPECT_EQ(once.component[4][0], -strain.component[4][3]);
  EXPECT_EQ(once.component[5][0], -strain.component[5][3]);
  EXPECT_EQ(once.component[3][0], strain.component[3][3]);
  EXPECT_EQ(mirrored(once, {true, false}).component, strain.component);
}

} // namespace
} // namespace ionskin::mechanics
