// SPDX-License-Identifier: Apache-2.0
#include "ionskin/live/reduction/channel_basis.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace ionskin::live {
namespace {

constexpr std::size_t cells_along = 12, heights = 2;

/// The norm of a strain of a few random waves at two points a cell, and its mean over each cell.
ChannelSamples random_samples(std::size_t count, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto between = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random() >> 11u) * 0x1p-53;
  };
  ChannelSamples samples;
  samples.points = {2 * cells_along, 1, heights};
  samples.cells = {cells_along, 1, heights};
  samples.at_points.resize(2 * cells_along * heights, static_cast<Eigen::Index>(count));
  samples.fields.resize(cells_along * heights, static_cast<Eigen::Index>(count));
  for (Eigen::Index sample = 0; sample < samples.fields.cols(); ++sample) {
    std::array<double, 8> wave{};
    for (double& amplitude : wave) {
      amplitude = between(-1, 1);
    }
    for (std::size_t at = 0; at < 2 * cells_along * heights; ++at) {
      const double x = (static_cast<double>(at % (2 * cells_along)) + 0.5) / cells_along - 1,
                   z = static_cast<double>(at / (2 * cells_along));
      double first = 0, second = 0;
      for (std::size_t i = 0; i < 4; ++i) {
        first += wave[i] * std::cos(static_cast<double>(i) * x + 0.3 * z);
        second += wave[4 + i] * std::sin(static_cast<double>(i + 1) * x + 0.2 * z);
      }
      samples.at_points(static_cast<Eigen::Index>(at), sample) =
          static_cast<float>(std::hypot(first, second));
    }
    for (Eigen::Index cell = 0; cell < samples.fields.rows(); ++cell) {
      samples.fields(cell, sample) =
          (samples.at_points(2 * cell, sample) + samples.at_points(2 * cell + 1, sample)) / 2;
    }
  }
  return samples;
}

ChannelMeasure even_measure() {
  return {std::vector<double>(2 * cells_along * heights, 1.0),
          std::vector<double>(cells_along, 1.0), Eigen::MatrixXd::Identity(heights, heights)};
}

Eigen::VectorXd told(const ChannelBasis& basis, const Eigen::VectorXf& at_points) {
  Eigen::VectorXd values(static_cast<Eigen::Index>(basis.points.size()));
  for (std::size_t i = 0; i < basis.points.size(); ++i) {
    values[static_cast<Eigen::Index>(i)] =
        static_cast<double>(at_points[static_cast<Eigen::Index>(basis.points[i])]);
  }
  return basis.field * (basis.fit * values);
}

TEST(ChannelBasis, TellsFieldsThatItHasNotSeen) {
  const ChannelBasis basis =
      channel_basis(random_samples(300, 1), even_measure(), Reflections(true, false));
  const ChannelSamples unseen = random_samples(50, 2);
  double error = 0, norm = 0;
  for (Eigen::Index i = 0; i < unseen.fields.cols(); ++i) {
    error +=
        (told(basis, unseen.at_points.col(i)) - unseen.fields.col(i).cast<double>()).squaredNorm();
    norm += unseen.fields.col(i).cast<double>().squaredNorm();
  }
  EXPECT_LT(std::sqrt(error / norm), 1e-2);
  EXPECT_LT(basis.unseen, 1e-2);
}

TEST(ChannelBasis, OfAMirroredSampleIsMirrored) {
  const Reflections reflections(true, false);
  const ChannelBasis basis = channel_basis(random_samples(300, 1), even_measure(), reflections);
  const ChannelSamples unseen = random_samples(20, 3);
  for (Eigen::Index i = 0; i < unseen.fields.cols(); ++i) {
    Eigen::VectorXf mirrored(unseen.at_points.rows());
    for (Eigen::Index at = 0; at < mirrored.size(); ++at) {
      mirrored[at] = unseen.at_points(static_cast<Eigen::Index>(reflections.image(
                                          1, static_cast<std::size_t>(at), unseen.points)),
                                      i);
    }
    const Eigen::VectorXd one = told(basis, unseen.at_points.col(i)), other = told(basis, mirrored);
    for (Eigen::Index at = 0; at < one.size(); ++at) {
      const auto image = static_cast<Eigen::Index>(
          reflections.image(1, static_cast<std::size_t>(at), unseen.cells));
      EXPECT_NEAR(one[at], other[image], 1e-5 * one.lpNorm<Eigen::Infinity>());
    }
  }
}

TEST(Reflections, AreTheirOwnInverses) {
  const Reflections both(true, true);
  ASSERT_EQ(both.count(), 4u);
  const std::array<std::size_t, 3> size{3, 4, 2};
  for (std::size_t g = 0; g < 4; ++g) {
    for (std::size_t i = 0; i < 24; ++i) {
      EXPECT_EQ(both.image(g, both.image(g, i, size), size), i);
    }
    EXPECT_EQ(both.sign(0, g), 1);
  }
  EXPECT_EQ(both.sign(1, 1), -1);
  EXPECT_EQ(both.sign(3, 3), 1);
  EXPECT_EQ(Reflections(false, true).count(), 2u);
}

} // namespace
} // namespace ionskin::live
