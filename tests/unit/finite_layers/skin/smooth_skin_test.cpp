// SPDX-License-Identifier: Apache-2.0
#include "ionskin/finite_layers/skin/layered_skin.hpp"
#include "paper_skin.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace ionskin::finite_layers {
namespace {

Skin long_skin() {
  return skin_of_size(15e-3, 2e-3);
}

ContactGrid two_cells() {
  return {{-1.5e-3, 0, 1.5e-3}, {-0.75e-3, 0}, true};
}

LayeredSkin skin() {
  return {long_skin(), two_cells(), skin_resolution(long_skin(), {3e-3, 0.25e-3})};
}

/// Largest difference of some order of equally spaced values.
double roughness(std::vector<double> values, int order) {
  for (int pass = 0; pass < order; ++pass) {
    for (std::size_t i = 0; i + 1 < values.size(); ++i) {
      values[i] = values[i + 1] - values[i];
    }
    values.pop_back();
  }
  double largest = 0;
  for (const double value : values) {
    largest = std::max(largest, std::abs(value));
  }
  return largest;
}

TEST(SmoothSkin, ComplianceDoesNotJumpAsTheSliderMoves) {
  const LayeredSkin layers = skin();
  const auto across = layers.across(1e-3);
  std::vector<double> along;
  for (int i = 0; i <= 120; ++i) {
    along.push_back(across.compliance(5e-3 + i * 25e-6)(1, 1));
  }
  EXPECT_LT(roughness(along, 3), 1e-6 * along.front());
}

TEST(SmoothSkin, ComplianceDoesNotJumpAsTheSliderMovesAcross) {
  const Skin wide = skin_of_size(15e-3, 6e-3);
  const ContactGrid grid{{-0.4e-3, 0.4e-3}, {-0.3e-3, 0.3e-3}};
  const LayeredSkin layers(wide, grid, skin_resolution(wide, {4e-3, 0.7e-3}));
  std::vector<double> across;
  for (int i = 0; i <= 40; ++i) {
    across.push_back(layers.across(1e-3 + i * 50e-6).compliance(6e-3)(2, 2));
  }
  EXPECT_LT(roughness(across, 4), 1.5e-5 * across.front());
}

TEST(SmoothSkin, StrainAlongASideHasNoRippleFarFromTheSlider) {
  const LayeredSkin layers = skin();
  const double side = 50e-6;
  FieldGrid grid{{}, {{side, side}}, {0, 15e-3}, {0, 1e-3}};
  for (int i = 0; i <= 20; ++i) {
    const double x = 11e-3 + i * 0.1e-3;
    grid.x.push_back({x, x});
  }
  const std::vector<double> forces{10, 3, 0, 10, 3, 0};
  const StrainField core =
      layers.fields({3e-6}, 0.1e-3).at({{grid, {7.5e-3, 1e-3}, forces}}).front().core;
  constexpr std::size_t xz = 4;
  EXPECT_LT(roughness(core.component[xz], 4), 1e-3 * std::abs(core.component[xz].front()));
}

} // namespace
} // namespace ionskin::finite_layers
