// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/position/interpolation_nodes.hpp"

#include "small_case.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <vector>

namespace ionskin::mechanics {
namespace {

constexpr double way_low = 4.5e-3, way_high = 10.5e-3, way_skin = 15e-3;
const EndCoordinate way_coordinate = end_coordinate(way_low, way_high, way_skin);

TEST(EndCoordinate, is_that_of_a_place_and_back) {
  for (const double place : {way_low, 6e-3, way_high}) {
    EXPECT_NEAR(way_coordinate.place(way_coordinate.at(place)), place, 1e-17);
  }
  EXPECT_NEAR(way_coordinate.at(way_low), -way_coordinate.at(way_high), 1e-14);
}

TEST(EndCoordinate, is_finite_wherever_a_slider_may_be) {
  // In the middle, close to an end that its edge may reach, and over all of the skin.
  for (const auto& [from, to] :
       {std::array{way_low, way_high}, {1e-9, 5e-3}, {-8e-3, 30e-3}, {0.0, way_skin}}) {
    const EndCoordinate any = end_coordinate(from, to, way_skin);
    EXPECT_TRUE(std::isfinite(any.at(from)) && std::isfinite(any.at(to))) << from;
    EXPECT_LT(any.at(from), any.at(to)) << from;
  }
}

TEST(InterpolationNodes, include_the_ends_and_ascend) {
  for (const bool in_pairs : {false, true}) {
    for (std::size_t count = 2; count <= most_interpolation_nodes + 1; ++count) {
      const auto nodes = interpolation_nodes(way_coordinate, way_low, way_high, count, in_pairs);
      ASSERT_EQ(nodes.size(), count);
      EXPECT_EQ(nodes.front(), way_low);
      EXPECT_EQ(nodes.back(), way_high);
      EXPECT_EQ(std::ranges::adjacent_find(nodes, std::ranges::greater_equal{}), nodes.end());
    }
  }
}

TEST(InterpolationNodes, in_pairs_mirror_each_other) {
  EXPECT_TRUE(mirrored_places(way_low, way_high, way_skin));
  EXPECT_FALSE(mirrored_places(1e-3, 7e-3, way_skin));
  for (std::size_t count = 2; count <= most_interpolation_nodes + 1; ++count) {
    const auto nodes = interpolation_nodes(way_coordinate, way_low, way_high, count, true);
    for (std::size_t i = 0; i < count; ++i) {
      EXPECT_NEAR(nodes[i] + nodes[count - 1 - i], way_skin, 1e-15 * way_skin);
    }
  }
}

TEST(InterpolationNodes, a_larger_count_keeps_the_nodes_of_a_smaller_one) {
  for (const std::size_t step : {1, 2}) {
    for (std::size_t count = 2; count + step <= most_interpolation_nodes; count += step) {
      const auto few = interpolation_nodes(way_coordinate, way_low, way_high, count, step == 2),
                 many = interpolation_nodes(way_coordinate, way_low, way_high, count + step,
                                            step == 2);
      EXPECT_TRUE(std::ranges::includes(many, few)) << count;
    }
  }
}

TEST(InterpolationNodes, no_count_of_nodes_amplifies_errors_much_over_tenfold) {
  for (const std::size_t step : {1, 2}) {
    for (std::size_t count = 2; count <= most_interpolation_nodes; count += step) {
      std::vector<double> nodes;
      for (const double node :
           interpolation_nodes(way_coordinate, way_low, way_high, count, step == 2)) {
        nodes.push_back(way_coordinate.at(node));
      }
      double lebesgue_constant = 0;
      for (int i = 0; i <= 1000; ++i) {
        const double at = nodes.front() + (nodes.back() - nodes.front()) * i / 1000.0;
        double sum = 0;
        for (const double weight : interpolation_weights(nodes, at)) {
          sum += std::abs(weight);
        }
        lebesgue_constant = std::max(lebesgue_constant, sum);
      }
      EXPECT_LT(lebesgue_constant, step == 2 ? 8.5 : 11.5) << count;
    }
  }
}

TEST(InterpolationNodes, weights_reproduce_polynomials) {
  const std::vector<double> nodes{0, 0.3, 0.9, 1.2, 1.7, 2};
  const auto weights = interpolation_weights(nodes, 0.7);
  double sum = 0;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    sum += weights[i] * std::pow(nodes[i], 5);
  }
  EXPECT_NEAR(sum, std::pow(0.7, 5), 1e-13);
}

TEST(InterpolationNodes, short_ways_are_expected_to_need_fewer_nodes) {
  const Case input = small_case(); // 5 mm long, under a flat slider
  const auto expected = [&](double low, double high) {
    const ExpectedNodes nodes = expected_nodes(input, 0, low, high);
    return std::array{nodes.first, nodes.all};
  };
  EXPECT_EQ(expected(1.5e-3, 3.5e-3), (std::array<std::size_t, 2>{6, 6}));
  EXPECT_EQ(expected(1e-3, 2e-3), (std::array<std::size_t, 2>{4, 5}));
  EXPECT_EQ(expected(2.3e-3, 2.7e-3), (std::array<std::size_t, 2>{4, 4}));
  EXPECT_EQ(expected(1e-3, 1.0001e-3), (std::array<std::size_t, 2>{2, 2}));
}

TEST(InterpolationNodes, narrow_shared_positions_begin_with_two_nodes) {
  Case input = small_case();
  input.numerics.shared.to = {3e-3, 1.2e-3};
  EXPECT_EQ(expected_nodes(input, 0, 1e-3, 1.2e-3).all, 2u);
  EXPECT_EQ(expected_nodes(input, 0, 1.5e-3, 3.5e-3).all, 6u);
}

} // namespace
} // namespace ionskin::mechanics
