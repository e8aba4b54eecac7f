// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/slider_track.hpp"

#include "small_case.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace ionskin::mechanics {
namespace {

TEST(SliderTrack, nodes_include_the_ends_and_are_symmetric) {
  for (std::size_t count = 2; count <= most_interpolation_nodes + 1; ++count) {
    const auto nodes = interpolation_nodes(6e-3, count);
    ASSERT_EQ(nodes.size(), count);
    EXPECT_EQ(nodes.front(), 0.0);
    EXPECT_EQ(nodes.back(), 6e-3);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      EXPECT_NEAR(nodes[i] + nodes[nodes.size() - 1 - i], 6e-3, 2e-18);
    }
  }
}

TEST(SliderTrack, a_larger_count_keeps_the_nodes_of_a_smaller_one) {
  for (std::size_t count = 4; count <= most_interpolation_nodes; count += 2) {
    const auto few = interpolation_nodes(6e-3, count - 2), many = interpolation_nodes(6e-3, count);
    EXPECT_TRUE(std::ranges::includes(many, few)) << count;
  }
}

TEST(SliderTrack, no_count_of_nodes_amplifies_errors_tenfold) {
  for (std::size_t count = 2; count <= most_interpolation_nodes; count += 2) {
    const auto nodes = interpolation_nodes(1, count);
    double lebesgue_constant = 0;
    for (int i = 0; i <= 1000; ++i) {
      double sum = 0;
      for (const double weight : interpolation_weights(nodes, i / 1000.0)) {
        sum += std::abs(weight);
      }
      lebesgue_constant = std::max(lebesgue_constant, sum);
    }
    EXPECT_LT(lebesgue_constant, 8.5) << count;
  }
}

TEST(SliderTrack, weights_reproduce_polynomials) {
  const auto nodes = interpolation_nodes(2, 6), weights = interpolation_weights(nodes, 0.7);
  double sum = 0;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    sum += weights[i] * std::pow(nodes[i], 5);
  }
  EXPECT_NEAR(sum, std::pow(0.7, 5), 1e-13);
}

TEST(SliderTrack, short_slides_are_expected_to_need_fewer_nodes) {
  const Case input = small_case();
  EXPECT_EQ(expected_node_count(input, {1e-3, 1e-3}, {3e-3, 1e-3}), 8u);
  EXPECT_EQ(expected_node_count(input, {1e-3, 1e-3}, {1.2e-3, 1e-3}), 4u);
  EXPECT_EQ(expected_node_count(input, {1e-3, 1e-3}, {1.0001e-3, 1e-3}), 2u);
}

TEST(SliderTrack, centre_moves_along_the_direction) {
  Case input = small_case();
  input.motion.direction = {0.6, 0.8};
  const auto centre = SliderTrack(input).centre(1e-3);
  EXPECT_NEAR(centre[0], 2.1e-3, 1e-17);
  EXPECT_NEAR(centre[1], 1.8e-3, 1e-17);
}

TEST(CanonicalPosition, mirrored_centres_share_one) {
  const Skin skin = small_case().skin;
  const auto a = canonical_position(skin, {1.5e-3, 0.8e-3}),
             b = canonical_position(skin, {3.5e-3, 1.2e-3});
  EXPECT_NEAR(a.centre[0], b.centre[0], 1e-17);
  EXPECT_NEAR(a.centre[1], b.centre[1], 1e-17);
  EXPECT_FALSE(a.reflect[0] || a.reflect[1]);
  EXPECT_TRUE(b.reflect[0] && b.reflect[1]);
  EXPECT_EQ(b.reflected({1, 2}), (std::array<double, 2>{-1, -2}));
}

} // namespace
} // namespace ionskin::mechanics
