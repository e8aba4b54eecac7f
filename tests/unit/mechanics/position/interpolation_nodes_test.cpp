// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/position/interpolation_nodes.hpp"

#include "small_case.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace ionskin::mechanics {
namespace {

TEST(InterpolationNodes, include_the_ends_and_are_symmetric) {
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

TEST(InterpolationNodes, a_larger_count_keeps_the_nodes_of_a_smaller_one) {
  for (std::size_t count = 4; count <= most_interpolation_nodes; count += 2) {
    const auto few = interpolation_nodes(6e-3, count - 2), many = interpolation_nodes(6e-3, count);
    EXPECT_TRUE(std::ranges::includes(many, few)) << count;
  }
}

TEST(InterpolationNodes, no_count_of_nodes_amplifies_errors_tenfold) {
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

TEST(InterpolationNodes, weights_reproduce_polynomials) {
  const auto nodes = interpolation_nodes(2, 6), weights = interpolation_weights(nodes, 0.7);
  double sum = 0;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    sum += weights[i] * std::pow(nodes[i], 5);
  }
  EXPECT_NEAR(sum, std::pow(0.7, 5), 1e-13);
}

TEST(InterpolationNodes, short_slides_are_expected_to_need_fewer_nodes) {
  const Case input = small_case();
  EXPECT_EQ(expected_node_count(input, {1e-3, 1e-3}, {3e-3, 1e-3}), 8u);
  EXPECT_EQ(expected_node_count(input, {1e-3, 1e-3}, {1.2e-3, 1e-3}), 4u);
  EXPECT_EQ(expected_node_count(input, {1e-3, 1e-3}, {1.0001e-3, 1e-3}), 2u);
}

TEST(InterpolationNodes, narrow_shared_positions_begin_with_two_nodes) {
  Case input = small_case();
  input.numerics.shared.to = {3e-3, 1.2e-3};
  EXPECT_EQ(expected_node_count(input, {1e-3, 1e-3}, {1.2e-3, 1e-3}), 2u);
  EXPECT_EQ(expected_node_count(input, {1e-3, 1e-3}, {3e-3, 1e-3}), 8u);
}

} // namespace
} // namespace ionskin::mechanics
