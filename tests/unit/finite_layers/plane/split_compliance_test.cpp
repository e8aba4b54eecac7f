// SPDX-License-Identifier: Apache-2.0
#include "ionskin/finite_layers/plane/box_modes.hpp"
#include "paper_skin.hpp"

#include <Eigen/Cholesky>
#include <gtest/gtest.h>

#include <cmath>

namespace ionskin::finite_layers {
namespace {

constexpr double length = 6e-3, width = 2e-3;

ContactGrid graded_grid() {
  return {{-0.5e-3, -0.49e-3, -0.4e-3, 0, 0.4e-3, 0.5e-3}, {-0.3e-3, -0.28e-3, 0, 0.3e-3}};
}

Eigen::MatrixXd compliance(const SurfaceCompliance& surface, const WaveSplit& split,
                           const ContactGrid& grid, double x, double y) {
  Eigen::MatrixXd result =
      plane_compliance(PlaneCompliance(surface, split), grid, own_images(grid));
  const BoxModes modes(surface, length, width, split);
  const auto rows = modes.rows(grid, y);
  const Eigen::ArrayXd all = Eigen::ArrayXd::Ones(modes.along_x().wave_numbers.size());
  for (const ModePart part : {ModePart::alike, ModePart::mirrored}) {
    add_modes(rows, modes.along_x(), part, all, grid, x, result);
  }
  return result;
}

TEST(SplitCompliance, DoesNotDependOnWhereTheWavesAreDivided) {
  const SurfaceCompliance surface(paper_skin());
  const ContactGrid grid = graded_grid();
  const Eigen::MatrixXd one = compliance(surface, WaveSplit(0.4e-3, 1e-4), grid, 2e-3, 1.1e-3),
                        other = compliance(surface, WaveSplit(0.8e-3, 1e-4), grid, 2e-3, 1.1e-3);
  EXPECT_LT((one - other).cwiseAbs().maxCoeff(), 1e-5 * one.cwiseAbs().maxCoeff());
}

TEST(SplitCompliance, IsThatOfAllModesOfTheBox) {
  // With waves that are all long, the modes are summed as far as cells of 0.1 mm see them.
  const SurfaceCompliance surface({elastic_layer(249e6, 0.45, 0.2e-3)});
  const ContactGrid grid{{-0.2e-3, -0.1e-3, 0.1e-3, 0.2e-3}, {-0.1e-3, 0, 0.1e-3}};
  const Eigen::MatrixXd split = compliance(surface, WaveSplit(0.6e-3, 1e-4), grid, 2e-3, 1.1e-3),
                        modes = compliance(surface, WaveSplit(0.04e-3, 1e-4), grid, 2e-3, 1.1e-3);
  EXPECT_LT((split - modes).cwiseAbs().maxCoeff(), 4e-5 * split.cwiseAbs().maxCoeff());
}

TEST(SplitCompliance, IsSymmetricAndPositive) {
  const SurfaceCompliance surface(paper_skin());
  const Eigen::MatrixXd found =
      compliance(surface, WaveSplit(0.6e-3, 1e-4), graded_grid(), 1.5e-3, 0.9e-3);
  EXPECT_LT((found - found.transpose()).cwiseAbs().maxCoeff(), 1e-12 * found.cwiseAbs().maxCoeff());
  EXPECT_EQ(found.llt().info(), Eigen::Success);
}

TEST(SplitCompliance, OfRowsHasAPartThatIsAlikeAtAllPlacesAndAMirroredOne) {
  const BoxModes modes(SurfaceCompliance(paper_skin()), length, width, WaveSplit(0.6e-3, 1e-4));
  const ContactGrid grid = graded_grid();
  const Eigen::ArrayXXd all = Eigen::ArrayXXd::Ones(modes.along_x().wave_numbers.size(),
                                                    modes.along_y().wave_numbers.size());
  const auto whole = modes.rows(grid, 1.1e-3), alike = modes.rows(grid, 0, ModePart::alike, all),
             mirrored = modes.rows(grid, 1.1e-3, ModePart::mirrored, all);
  ASSERT_EQ(whole.size(), alike.size());
  for (std::size_t m = 0; m < whole.size(); ++m) {
    EXPECT_LT((alike[m] + mirrored[m] - whole[m]).cwiseAbs().maxCoeff(),
              1e-12 * whole.front().cwiseAbs().maxCoeff());
  }
}

TEST(SplitCompliance, OfTheHalfIsThatOfTheWholeUnderMirroredForces) {
  const SurfaceCompliance surface(paper_skin());
  const ContactGrid half{{-0.2e-3, 0, 0.3e-3}, {-0.3e-3, -0.28e-3, 0}, true},
      whole{half.x, {-0.3e-3, -0.28e-3, 0, 0.28e-3, 0.3e-3}};
  const WaveSplit split(0.6e-3, 1e-4);
  const Eigen::MatrixXd of_half = compliance(surface, split, half, 2e-3, width / 2),
                        of_whole = compliance(surface, split, whole, 2e-3, width / 2);
  const Eigen::Index columns = 2;
  for (Eigen::Index at = 0; at < 4; ++at) {
    for (Eigen::Index from = 0; from < 4; ++from) {
      const Eigen::Index image = from % columns + columns * (3 - from / columns);
      Eigen::Matrix3d mirrored = of_whole.block<3, 3>(3 * at, 3 * image);
      mirrored.col(2) *= -1;
      const Eigen::Matrix3d expected = of_whole.block<3, 3>(3 * at, 3 * from) + mirrored;
      EXPECT_LT((of_half.block<3, 3>(3 * at, 3 * from) - expected).cwiseAbs().maxCoeff(),
                1e-9 * of_whole.cwiseAbs().maxCoeff());
    }
  }
}

TEST(SplitCompliance, IsCerrutisAndBoussinesqsOnAThickLayer) {
  // Far above the base and far from the faces, under small cells.
  const ElasticLayer thick = elastic_layer(1e6, 0.3, 50e-3);
  const SurfaceCompliance surface({thick});
  const PlaneCompliance skin(surface, WaveSplit(40e-3, 1e-4));
  const Interval x_at{0, 2e-6}, y{0, 2e-6}, x_from{10e-6, 12e-6};
  const CellCompliance found = plane_compliance(skin, x_at, y, x_from, y);
  const double r = 10e-6, factor = 1 / (2 * M_PI * thick.shear_modulus * r);
  EXPECT_NEAR(found(0, 0), factor * 0.7, 0.01 * factor);
  EXPECT_NEAR(found(1, 1), factor, 0.01 * factor);
  EXPECT_NEAR(found(2, 2), factor * 0.7, 0.01 * factor);
  EXPECT_NEAR(found(1, 0), factor * 0.2, 0.01 * factor); // drawn towards the pressure
  EXPECT_NEAR(found(0, 1), -factor * 0.2, 0.01 * factor);
}

} // namespace
} // namespace ionskin::finite_layers
