// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/position/interpolation_error.hpp"

#include "ionskin/mechanics/position/interpolation_nodes.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>

namespace ionskin::mechanics {
namespace {

/// A strain whose first component is given at two points.
using Strain = std::function<std::array<double, 2>(double)>;

/// The ends, the middle and pairs between 0 and 2.
std::vector<double> places(std::size_t count) {
  return interpolation_nodes({-1e6, 1e6}, 0, 2, count, false);
}

std::vector<NodeStrain> sliding(const Strain& strain, std::size_t count) {
  std::vector<NodeStrain> steady;
  for (const double time : places(count)) {
    const auto values = strain(time);
    CoreStrain strain_here;
    strain_here.component[0] = {values[0], values[1]};
    steady.push_back({3 + time, std::make_shared<const CoreStrain>(strain_here)});
  }
  return steady;
}

/// Largest error of the polynomial between the nodes, over the largest norm.
double true_error(const Strain& strain, std::size_t count) {
  const auto nodes = places(count);
  double worst = 0, largest = 0;
  for (int i = 0; i <= 400; ++i) {
    const double time = i / 200.0;
    const auto weights = interpolation_weights(nodes, time);
    auto difference = strain(time);
    largest = std::max(largest, std::hypot(difference[0], difference[1]));
    for (std::size_t node = 0; node < count; ++node) {
      const auto values = strain(nodes[node]);
      difference[0] -= weights[node] * values[0];
      difference[1] -= weights[node] * values[1];
    }
    worst = std::max(worst, std::hypot(difference[0], difference[1]));
  }
  return worst / largest;
}

/// Coefficients that decay by 0.27 from one to the next: a pole beyond the end of the track.
std::array<double, 2> pole(double time) {
  return {5 + 1 / (2.97 - time), 1 + 0.5 / (0.97 + time)};
}

TEST(InterpolationError, norms_are_those_of_chebyshev_coefficients) {
  const auto norms = chebyshev_norms(sliding(
      [](double time) {
        const double x = time - 1;
        return std::array<double, 2>{2 * x * x - 1, 0.5 * x};
      },
      6));
  const double largest = std::hypot(1, 0.5);
  const std::array<double, 6> expected{0, 0.5 / largest, 1 / largest, 0, 0, 0};
  for (std::size_t order = 0; order < 6; ++order) {
    EXPECT_NEAR(norms[order], expected[order], 1e-12) << order;
  }
}

TEST(InterpolationError, estimate_is_close_to_the_error) {
  for (const std::size_t count : {3, 4, 5, 6, 7, 8, 10, 12}) {
    const double estimate = interpolation_error(sliding(pole, count)).estimate;
    const double error = true_error(pole, count);
    EXPECT_GT(estimate, 0.9 * error) << count;
    EXPECT_LT(estimate, 6 * error) << count;
  }
}

TEST(InterpolationError, is_large_across_a_kink) {
  const Strain kink = [](double time) {
    return std::array<double, 2>{1 + std::abs(time - 0.7), 0.0};
  };
  const double estimate = interpolation_error(sliding(kink, 8)).estimate;
  EXPECT_GT(estimate, 0.3 * true_error(kink, 8));
  EXPECT_GT(estimate, 0.02);
}

TEST(InterpolationError, nodes_without_strain_count_as_zero) {
  std::vector<NodeStrain> steady = sliding([](double) { return std::array<double, 2>{1, 1}; }, 4);
  EXPECT_NEAR(interpolation_error(steady).estimate, 0, 1e-12);
  steady.front().strain = nullptr;
  EXPECT_GT(interpolation_error(steady).estimate, 0.1);
  for (NodeStrain& node : steady) {
    node.strain = nullptr;
  }
  EXPECT_EQ(interpolation_error(steady).estimate, 0);
}

TEST(InterpolationError, more_nodes_are_wanted_until_the_tolerance_is_kept) {
  EXPECT_EQ(wanted_node_count(4, {1e-5, 0.25}, 5e-5, false), 4u);
  EXPECT_EQ(wanted_node_count(4, {1e-4, 0.25}, 5e-5, false), 5u);
  EXPECT_EQ(wanted_node_count(4, {1e-4, 0.25}, 5e-5, true), 6u);
  EXPECT_EQ(wanted_node_count(4, {3e-3, 0.25}, 5e-5, false), 7u);
  EXPECT_EQ(wanted_node_count(4, {3e-3, 0.25}, 5e-5, true), 8u);
  EXPECT_EQ(wanted_node_count(4, {1e-2, 0.9}, 5e-5, false), most_interpolation_nodes);
  EXPECT_EQ(wanted_node_count(most_interpolation_nodes, {1e-2, 0.9}, 5e-5, false),
            most_interpolation_nodes);
}

TEST(InterpolationError, of_what_is_no_number_is_none_and_asks_for_no_more_nodes) {
  for (const std::size_t count : {2, 3, 4, 5}) {
    const InterpolationError error = interpolation_error(sliding(
        [](double time) {
          return std::array<double, 2>{time == 2 ? std::nan("") : 1, 1};
        },
        count));
    EXPECT_TRUE(std::isnan(error.estimate)) << count;
    EXPECT_EQ(wanted_node_count(count, error, 5e-5, false), count);
  }
}

} // namespace
} // namespace ionskin::mechanics
