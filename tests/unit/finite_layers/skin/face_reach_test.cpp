// SPDX-License-Identifier: Apache-2.0
#include "ionskin/finite_layers/skin/layered_skin.hpp"
#include "paper_skin.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace ionskin::finite_layers {
namespace {

Skin wide_skin() {
  return skin_of_size(8e-3, 5e-3);
}

constexpr std::array<double, 2> slider_centre{3e-3, 2.2e-3};

ContactGrid four_cells() {
  return {{-0.4e-3, 0, 0.4e-3}, {-0.3e-3, 0, 0.3e-3}, false};
}

SkinResolution resolution() {
  return skin_resolution(wide_skin(), {2.6e-3, 1.9e-3});
}

/// Resolution with all the waves along the faces that a slider beside them needs.
SkinResolution finest() {
  SkinResolution result = resolution();
  result.ends_reach = result.sides_reach = result.reach;
  return result;
}

double largest(const std::vector<double>& values) {
  double result = 0;
  for (const double value : values) {
    result = std::max(result, std::abs(value));
  }
  return result;
}

TEST(FaceReach, IsTheClearanceRoundedDown) {
  const SkinResolution own = resolution();
  EXPECT_DOUBLE_EQ(own.reach, 0.5e-3);
  EXPECT_DOUBLE_EQ(own.ends_reach, 2e-3);
  EXPECT_DOUBLE_EQ(own.sides_reach, std::sqrt(2.0) * 1e-3);
  const SkinResolution beside = skin_resolution(wide_skin(), {0.1e-3, 1.9e-3});
  EXPECT_DOUBLE_EQ(beside.ends_reach, beside.reach);
}

TEST(FaceReach, LeavesOutNoWaveThatComplianceFeels) {
  const auto compliance = [](const SkinResolution& resolved) {
    return LayeredSkin(wide_skin(), four_cells(), resolved)
        .across(slider_centre[1])
        .compliance(slider_centre[0]);
  };
  const Eigen::MatrixXd own = compliance(resolution()), all = compliance(finest());
  EXPECT_LT((own - all).cwiseAbs().maxCoeff(), 1e-6 * all.cwiseAbs().maxCoeff());
}

TEST(FaceReach, LeavesOutNoWaveThatStrainFeels) {
  FieldGrid grid{{}, {}, {0, 4e-3, 8e-3}, {0, 2.5e-3, 5e-3}};
  for (double x = 10e-6; x < 8e-3; x += 0.25e-3) {
    grid.x.push_back({x, x});
  }
  for (double y = 10e-6; y < 5e-3; y += 0.25e-3) {
    grid.y.push_back({y, y});
  }
  const std::vector<double> forces{3, 1, 0, 2, 1, 0.3, 4, 1, -0.2, 1, 0.5, 0.1};
  const auto core = [&](const SkinResolution& resolved) {
    const LayeredSkin skin(wide_skin(), four_cells(), resolved);
    return skin.fields({3e-6, 90e-6}, 0.25e-3).at({{grid, slider_centre, forces}}).front().core;
  };
  const StrainField own = core(resolution()), all = core(finest());
  for (std::size_t component = 0; component < 6; ++component) {
    const std::vector<double>& expected = all.component[component];
    double inside = 0, at_faces = 0; // largest differences
    for (std::size_t at = 0; at < expected.size(); ++at) {
      const double x = grid.x[at % grid.x.size()].from,
                   y = grid.y[at / grid.x.size() % grid.y.size()].from;
      const double to_end = std::min(x, 8e-3 - x), to_side = std::min(y, 5e-3 - y);
      const double difference = std::abs(own.component[component][at] - expected[at]);
      // Strain is singular at the corners of the skin, for any number of waves.
      constexpr double two_thicknesses = 0.4e-3;
      if (std::min(to_end, to_side) > two_thicknesses) {
        inside = std::max(inside, difference);
      } else if (std::max(to_end, to_side) > two_thicknesses) {
        at_faces = std::max(at_faces, difference);
      }
    }
    EXPECT_LT(inside, 1e-4 * largest(expected)) << component;
    EXPECT_LT(at_faces, 1e-3 * largest(expected)) << component;
  }
}

} // namespace
} // namespace ionskin::finite_layers
