// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/elasticity/electrode_membrane.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>

namespace ionskin::mechanics {
namespace {

using Vector = std::array<double, 3>;

// Two element rows below the core, three above it: layers 0, 1 (core) and 2.
const mesh::MeshLines skin_lines{{0, 0.3, 1.0}, {0, 0.5, 0.9}, {0, 0.2, 0.3, 0.7, 0.8, 1.0, 1.1}};
const std::vector<std::size_t> layer_of_row{0, 0, 1, 2, 2, 2};
constexpr std::array<std::size_t, 2> core_z{2, 3};
const ElasticLaw lower = isotropic_elasticity({"lower", 2.0, 0.3}),
                 core = isotropic_elasticity({"core", 0.1, 0.45}),
                 upper = isotropic_elasticity({"upper", 3.0, 0.2});
const std::vector<ElasticLaw> law_of_row{lower, lower, core, upper, upper, upper};

/// Largest membrane stress of both electrodes under a displacement that vanishes on the base.
std::vector<double> stress_of(const std::function<Vector(double, double, double)>& displacement) {
  const ElasticSpace space(skin_lines, {{"base", Face::base, {true, true, true}}});
  std::vector<double> values(static_cast<std::size_t>(space.unknowns()));
  const auto place = [](const std::vector<double>& line, std::size_t i) {
    return i % 2 == 0 ? line[i / 2] : 0.5 * (line[i / 2] + line[i / 2 + 1]);
  };
  const auto [nx, ny, nz] = space.elements();
  for (std::size_t k = 0; k <= 2 * nz; ++k) {
    for (std::size_t j = 0; j <= 2 * ny; ++j) {
      for (std::size_t i = 0; i <= 2 * nx; ++i) {
        const Vector u =
            displacement(place(skin_lines.x, i), place(skin_lines.y, j), place(skin_lines.z, k));
        const std::array<int, 3>& unknown = space.unknown(space.node_at(i, j, k));
        for (std::size_t c = 0; c < 3; ++c) {
          if (unknown[c] >= 0) {
            values[static_cast<std::size_t>(unknown[c])] = u[c];
          }
        }
      }
    }
  }
  const ElectrodeMembrane membrane(space, skin_lines, law_of_row, layer_of_row, core_z);
  std::vector<double> average(static_cast<std::size_t>(membrane.rows()));
  membrane.average_strain(values.data(), average.data());
  return membrane.largest_stress(average.data());
}

void expect_stress(const std::vector<double>& stress, double in_lower, double in_upper) {
  ASSERT_EQ(stress.size(), 2u);
  EXPECT_NEAR(stress[0], in_lower, 1e-12 * in_lower);
  EXPECT_NEAR(stress[1], in_upper, 1e-12 * in_upper);
}

TEST(ElectrodeMembrane, simple_shear_has_root_three_times_the_shear_stress) {
  const double gamma = 0.01;
  expect_stress(stress_of([&](double, double, double z) {
                  return Vector{gamma * z, 0, 0};
                }),
                std::sqrt(3.0) * lower.shear_modulus * gamma,
                std::sqrt(3.0) * upper.shear_modulus * gamma);
  expect_stress(stress_of([&](double, double, double z) {
                  return Vector{0, -gamma * z, 0};
                }),
                std::sqrt(3.0) * lower.shear_modulus * gamma,
                std::sqrt(3.0) * upper.shear_modulus * gamma);
}

TEST(ElectrodeMembrane, uniaxial_tension_has_its_stress) {
  // Lateral contraction needs a free base: the upper electrode's share alone is uniaxial.
  const double strain = 0.002, nu = 0.2;
  const auto stress = stress_of([&](double x, double y, double z) {
    return Vector{strain * x, -nu * strain * y, -nu * strain * z};
  });
  EXPECT_NEAR(stress[1], 3.0 * strain, 1e-12);
}

TEST(ElectrodeMembrane, confined_compression_has_twice_the_shear_modulus_times_the_strain) {
  const double strain = -0.02;
  expect_stress(stress_of([&](double, double, double z) {
                  return Vector{0, 0, strain * z};
                }),
                2 * lower.shear_modulus * 0.02, 2 * upper.shear_modulus * 0.02);
}

TEST(ElectrodeMembrane, strain_is_averaged_through_the_layer_and_over_the_column) {
  // u_x = z^2: du_x/dz averages to the sum of the layer's ends. u_x = x^2 z: that of the column's
  // share, x0^2 + x0 x1 + x1^2 over 3, beside e_xx.
  const double root_three = std::sqrt(3.0);
  expect_stress(stress_of([](double, double, double z) {
                  return Vector{z * z, 0, 0};
                }),
                root_three * lower.shear_modulus * 0.3,
                root_three * upper.shear_modulus * (0.7 + 1.1));
  const auto stress = stress_of([](double, double y, double z) { return Vector{y * y * z, 0, 0}; });
  const double y0 = 0.5, y1 = 0.9, z0 = 0.7, z1 = 1.1;
  const double e_xz = 0.5 * (y0 * y0 + y0 * y1 + y1 * y1) / 3;
  const double e_xy = 0.5 * (y0 + y1) * 0.5 * (z0 + z1);
  EXPECT_NEAR(stress[1], 2 * root_three * upper.shear_modulus * std::hypot(e_xz, e_xy), 1e-12);
}

TEST(ElectrodeMembrane, a_stress_that_is_no_number_is_the_largest) {
  const auto stress = stress_of([](double x, double, double z) {
    return Vector{z > 1.0 && x < 0.1 ? std::nan("") : z, 0, 0};
  });
  EXPECT_FALSE(std::isnan(stress[0]));
  EXPECT_TRUE(std::isnan(stress[1]));
}

} // namespace
} // namespace ionskin::mechanics
