// SPDX-License-Identifier: Apache-2.0
#include "ionskin/finite_layers/faces/thickness_column.hpp"
#include "ionskin/finite_layers/thickness/depth_strain.hpp"
#include "paper_skin.hpp"

#include <Eigen/Cholesky>
#include <gtest/gtest.h>

#include <cmath>

namespace ionskin::finite_layers {
namespace {

std::array<double, 8> values(const DepthStrain& strain) {
  return {strain.stretch_by_along,
          strain.stretch_by_normal,
          strain.rise_by_along,
          strain.rise_by_normal,
          strain.shear_by_along,
          strain.shear_by_normal,
          strain.twist,
          strain.across};
}

double largest(const DepthStrain& strain) {
  double result = 0;
  for (const double value : values(strain)) {
    result = std::max(result, std::abs(value));
  }
  return result;
}

const std::vector<DepthLevel>& levels() {
  static const std::vector<DepthLevel> all{{0, {}}, {1, 20e-6}, {1, 150e-6},
                                           {1, {}}, {2, 4e-6},  {2, {}}};
  return all;
}

TEST(DepthStrain, OfALongWaveIsThatOfAnEvenlyLoadedColumn) {
  const auto layers = paper_skin();
  const std::vector<DepthStrain> found = depth_strain(layers, 1e-6, levels());
  for (std::size_t i = 0; i < found.size(); ++i) {
    const ElasticLayer& layer = layers[levels()[i].layer];
    const double normal = 1 / layer.oedometric_modulus(), shear = 1 / layer.shear_modulus;
    EXPECT_NEAR(found[i].rise_by_normal, normal, 1e-6 * normal);
    EXPECT_NEAR(found[i].shear_by_along, shear, 1e-6 * shear);
    EXPECT_NEAR(found[i].across, shear, 1e-6 * shear);
    EXPECT_NEAR(found[i].stretch_by_along, 0, 1e-6 * shear);
    EXPECT_NEAR(found[i].stretch_by_normal, 0, 1e-6 * shear);
  }
}

TEST(DepthStrain, IsThatOfFineFiniteElements) {
  const auto layers = paper_skin();
  const ThicknessColumn column(layers,
                               {{1, 1}, {1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1}, {1, 1, 1}}, 8);
  const Eigen::Index n = column.nodes();
  // Layers are thin beside some of these waves, and thick beside others.
  for (const double k : {3e2, 2.5e3, 3e3, 2e4, 4.9e4, 5.1e4, 1e5}) {
    Eigen::MatrixXd loads = Eigen::MatrixXd::Zero(2 * n, 2);
    loads(n - 1, 0) = loads(2 * n - 1, 1) = 1;
    const Eigen::MatrixXd plane = column.plane_strain(k).llt().solve(loads);
    const Eigen::VectorXd across = column.antiplane(k).llt().solve(loads.col(0).head(n));
    const std::vector<DepthStrain> found = depth_strain(layers, k, levels());
    for (std::size_t i = 0; i < found.size(); ++i) {
      const auto at = column.at(levels()[i]);
      const Eigen::RowVector2d along = at.value * plane.topRows(n),
                               along_slope = at.slope * plane.topRows(n),
                               up = at.value * plane.bottomRows(n),
                               rise = at.slope * plane.bottomRows(n);
      const DepthStrain expected{k * along(0),
                                 k * along(1),
                                 rise(0),
                                 rise(1),
                                 along_slope(0) - k * up(0),
                                 along_slope(1) - k * up(1),
                                 k * at.value.dot(across),
                                 at.slope.dot(across)};
      for (std::size_t c = 0; c < 8; ++c) {
        EXPECT_NEAR(values(found[i])[c], values(expected)[c], 2e-6 * largest(expected))
            << "k " << k << ", level " << i << ", value " << c;
      }
    }
  }
}

TEST(DepthStrain, OfAMeanIsTheMeanOverTheThickness) {
  const auto layers = paper_skin();
  std::vector<DepthLevel> points;
  const LobattoElement rule(12, layers[1].thickness);
  for (const double height : rule.points) {
    points.push_back({1, height});
  }
  for (const double k : {2e3, 2e4}) {
    const std::vector<DepthStrain> at = depth_strain(layers, k, points);
    const DepthStrain mean = depth_strain(layers, k, {{1, {}}}).front();
    for (std::size_t c = 0; c < 8; ++c) {
      double sum = 0;
      for (std::size_t i = 0; i < at.size(); ++i) {
        sum += rule.weights(static_cast<Eigen::Index>(i)) * values(at[i])[c];
      }
      EXPECT_NEAR(values(mean)[c], sum / layers[1].thickness, 1e-8 * largest(mean)) << c;
    }
  }
}

} // namespace
} // namespace ionskin::finite_layers
