// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/surface/traction_profile.hpp"

#include "small_case.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

namespace ionskin::mechanics {
namespace {

/// Weighted means of x and x^2 over an element edge, from the means of its shape functions.
std::array<double, 2> means_of_powers(const TractionProfile& profile, double from, double to) {
  const auto shape = profile.mean_shape_values(from, to);
  const double middle = (from + to) / 2;
  EXPECT_NEAR(shape[0] + shape[1] + shape[2], 1, 1e-14);
  return {shape[0] * from + shape[1] * middle + shape[2] * to,
          shape[0] * from * from + shape[1] * middle * middle + shape[2] * to * to};
}

TEST(TractionProfile, even_means_are_exact_for_quadratics) {
  const auto [x, x2] = means_of_powers(TractionProfile(0), 1, 3);
  EXPECT_NEAR(x, 2, 1e-14);
  EXPECT_NEAR(x2, 13.0 / 3, 1e-14);
}

TEST(TractionProfile, punch_means_are_exact_for_quadratics) {
  // Over [-a, b] the integrals of 1, x, x^2 over sqrt(a^2 - x^2) are asin(b/a) + pi/2, -root and
  // (a^2 (asin(b/a) + pi/2) - b root) / 2 with root = sqrt(a^2 - b^2).
  constexpr double a = 2;
  for (const double b : {-1.9, 0.0, 1.5}) {
    const double angle = std::asin(b / a) + std::numbers::pi / 2, root = std::sqrt(a * a - b * b);
    const auto [x, x2] = means_of_powers(TractionProfile(a), -a, b);
    EXPECT_NEAR(x, -root / angle, 1e-9) << b;
    EXPECT_NEAR(x2, (a * a * angle - b * root) / (2 * angle), 1e-9) << b;
  }
}

TEST(TractionProfile, small_cells_at_an_edge_carry_the_inverse_square_root) {
  // Of 1/sqrt(t) on [0, 1] the means of t and t^2 are 1/3 and 1/5; far inside it is even.
  constexpr double a = 1, small = 1e-5;
  const auto edge = TractionProfile(a).mean_shape_values(-a, -a + small);
  EXPECT_NEAR(edge[1] / 2 + edge[2], 1.0 / 3, 1e-5);
  EXPECT_NEAR(edge[1] / 4 + edge[2], 1.0 / 5, 1e-5);
  const auto inside = TractionProfile(a).mean_shape_values(0, small);
  EXPECT_NEAR(inside[0], 1.0 / 6, 1e-5);
  EXPECT_NEAR(inside[2], 1.0 / 6, 1e-5);
}

TEST(TractionProfile, only_edges_on_the_skin_are_singular) {
  Case input = small_case();
  const auto is_even = [](const Case& of, std::size_t direction) {
    const mesh::SkinMesh mesh(of);
    const auto shape = TractionProfile(mesh, direction).mean_shape_values(-0.2e-3, -0.1e-3);
    return std::abs(shape[0] - shape[2]) < 1e-14;
  };
  EXPECT_FALSE(is_even(input, 0));
  EXPECT_FALSE(is_even(input, 1));
  input.slider.size[1] = input.skin.width;
  EXPECT_TRUE(is_even(input, 1)) << "the slider ends with the skin";
  input = small_case();
  input.slider.parameters["edge_radius"] = 0.05e-3;
  EXPECT_TRUE(is_even(input, 0)) << "a rounded edge has no singularity";
}

} // namespace
} // namespace ionskin::mechanics
