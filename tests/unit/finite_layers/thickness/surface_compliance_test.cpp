// SPDX-License-Identifier: Apache-2.0
#include "ionskin/finite_layers/thickness/surface_compliance.hpp"

#include "ionskin/finite_layers/faces/thickness_column.hpp"
#include "ionskin/finite_layers/thickness/layer_stiffness.hpp"
#include "paper_skin.hpp"

#include <Eigen/Cholesky>
#include <gtest/gtest.h>

#include <cmath>

namespace ionskin::finite_layers {
namespace {

/// Compliance of one bonded layer, docs/model.md (37), written without hyperbolic functions that
/// overflow.
WaveCompliance bonded_layer(const ElasticLayer& layer, double k) {
  const double nu = layer.poissons_ratio(), depth = k * layer.thickness;
  const double e = std::exp(-2 * depth), cosh2 = (1 + e) * (1 + e) / 4,
               sinh2 = (1 - e) * (1 - e) / 4, sinh_cosh = (1 - e * e) / 4;
  const double d = (3 - 4 * nu) * cosh2 + e * (depth * depth + (1 - 2 * nu) * (1 - 2 * nu));
  const double factor = 1 / (layer.shear_modulus * k);
  return {factor * (1 - nu) * ((3 - 4 * nu) * sinh_cosh - e * depth) / d,
          factor * (1 - nu) * ((3 - 4 * nu) * sinh_cosh + e * depth) / d, factor * std::tanh(depth),
          factor * ((1 - 2 * nu) * (3 - 4 * nu) * sinh2 - e * depth * depth) / (2 * d)};
}

void expect_near(const WaveCompliance& found, const WaveCompliance& expected, double tolerance) {
  EXPECT_NEAR(found.normal, expected.normal, tolerance * expected.normal);
  EXPECT_NEAR(found.along, expected.along, tolerance * expected.along);
  EXPECT_NEAR(found.across, expected.across, tolerance * expected.across);
  EXPECT_NEAR(found.mixed, expected.mixed, tolerance * std::sqrt(expected.normal * expected.along));
}

TEST(SurfaceCompliance, IsThatOfOneBondedLayerInClosedForm) {
  for (const double nu : {0.0, 0.3, 0.49}) {
    const ElasticLayer layer = elastic_layer(249e6, nu, 0.2e-3);
    for (double depth = 1e-3; depth < 200; depth *= 1.7) {
      expect_near(wave_compliance({layer}, depth / layer.thickness),
                  bonded_layer(layer, depth / layer.thickness), 1e-9);
    }
  }
}

TEST(SurfaceCompliance, DoesNotDependOnHowALayerIsCut) {
  const ElasticLayer whole = elastic_layer(249e6, 0.49, 0.2e-3);
  ElasticLayer lower = whole, upper = whole;
  lower.thickness *= 0.3;
  upper.thickness *= 0.7;
  for (double depth = 1e-3; depth < 200; depth *= 1.7) {
    const double k = depth / whole.thickness;
    expect_near(wave_compliance({lower, upper}, k), wave_compliance({whole}, k), 1e-9);
  }
}

TEST(SurfaceCompliance, PassesFromAUniformColumnToTheHalfSpaceOfTheTopLayer) {
  const SurfaceCompliance surface(paper_skin());
  const double thickness = surface.thickness();
  const WaveCompliance uniform = uniform_compliance(surface.layers());
  expect_near(wave_compliance(surface.layers(), 1e-6 / thickness),
              {uniform.normal, uniform.along, uniform.across,
               wave_compliance(surface.layers(), 1e-6 / thickness).mixed},
              1e-7);
  const double k = surface.half_space_from();
  const WaveCompliance& half_space = surface.half_space();
  expect_near(
      wave_compliance(surface.layers(), k),
      {half_space.normal / k, half_space.along / k, half_space.across / k, half_space.mixed / k},
      1e-12);
}

void expect_tabulated(const std::vector<ElasticLayer>& layers, double tolerance) {
  const SurfaceCompliance surface(layers);
  for (double k = 1e-5 / surface.thickness(); k < 100 / surface.top_thickness(); k *= 1.37) {
    expect_near(surface.at(k), wave_compliance(layers, k), tolerance);
  }
}

TEST(SurfaceCompliance, IsTabulatedCloselyOverAllWaveNumbers) {
  expect_tabulated(paper_skin(), 2e-6);
  expect_tabulated({elastic_layer(249e6, 0.3, 50e-6)}, 2e-6);
  // A film of a ten-thousandth of the thickness, a hundred thousand times as stiff: rounding in the
  // stiffness of its element is felt.
  expect_tabulated({elastic_layer(1e6, 0.499, 1e-3), elastic_layer(1e11, 0.3, 0.1e-6)}, 3e-5);
}

TEST(SurfaceCompliance, IsWhatFiniteElementsThroughTheThicknessConvergeTo) {
  const auto layers = paper_skin();
  const ThicknessColumn column(layers, {{1}, {1, 2, 4, 4, 2, 1}, {2, 1}}, 4);
  const Eigen::Index n = column.nodes();
  for (const double k : {1e2, 1e3, 1e4, 1e5}) {
    const Eigen::LLT<Eigen::MatrixXd> stiffness(column.plane_strain(k));
    const Eigen::VectorXd pressed = stiffness.solve(Eigen::VectorXd::Unit(2 * n, 2 * n - 1)),
                          sheared = stiffness.solve(Eigen::VectorXd::Unit(2 * n, n - 1)),
                          across = column.antiplane(k).llt().solve(Eigen::VectorXd::Unit(n, n - 1));
    expect_near({pressed(2 * n - 1), sheared(n - 1), across(n - 1), pressed(n - 1)},
                wave_compliance(layers, k), 1e-6);
  }
}

} // namespace
} // namespace ionskin::finite_layers
