// SPDX-License-Identifier: Apache-2.0
#include "ionskin/history/strain_projection.hpp"

#include "ionskin/history/shear_statistics.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace ionskin::history {
namespace {

/// Rough values that ride with a slider from x = 1 to x = 2 over a 4 x 2 x 1 core.
CoreHistory riding_history() {
  CoreHistory history;
  history.frame = Frame::slider;
  history.grid = {{-2, -0.7, -0.5, 0.4, 1.1, 3}, {-1, -0.2, 0.3, 1}, {0, 0.2, 0.9, 1}};
  history.length = 4;
  history.width = 2;
  history.time = {0, 1, 3};
  history.slider_x = {1, 1.3, 2};
  for (int sample = 0; sample < 3; ++sample) {
    StrainField field(history.grid.values());
    for (std::size_t i = 0; i < field.size(); ++i) {
      field[i] = std::sin(1.0 + 0.7 * static_cast<double>(i) + sample);
    }
    history.shear().push_back(std::make_shared<StrainField>(field));
  }
  return history;
}

TEST(StrainProjection, ConservesTheIntegralAtEveryInstant) {
  const auto history = riding_history();
  std::vector<double> x_edges;
  for (int i = 0; i <= 17; ++i) {
    x_edges.push_back(4.0 * i / 17);
  }
  const std::vector<double> y_edges{0, 0.5, 1.7, 2};
  const std::vector<double> z_nodes{0, 0.05, 0.4, 0.95, 1};
  const StrainProjection projection(history, history.channel(channel_name::shear), x_edges, y_edges,
                                    hat_averages(history.grid.z_nodes, z_nodes));
  std::vector<double> field;
  for (const double time : {0.0, 0.41, 1.0, 2.9, 3.0}) {
    projection.evaluate(time, field);
    ASSERT_EQ(field.size(), 17u * 3 * 5);
    double integral = 0;
    for (std::size_t k = 0; k < z_nodes.size(); ++k) {
      const double below = k == 0 ? 0 : z_nodes[k] - z_nodes[k - 1];
      const double above = k + 1 == z_nodes.size() ? 0 : z_nodes[k + 1] - z_nodes[k];
      for (std::size_t j = 0; j < 3; ++j) {
        for (std::size_t i = 0; i < 17; ++i) {
          integral += 0.5 * (below + above) * (y_edges[j + 1] - y_edges[j]) *
                      (x_edges[i + 1] - x_edges[i]) * field[(k * 3 + j) * 17 + i];
        }
      }
    }
    EXPECT_NEAR(integral, shear_integral(history, time), 1e-13) << "at " << time;
  }
}

TEST(StrainProjection, IntegralsOfRidingCellsAreLinearBetweenTheSamples) {
  const auto history = riding_history();
  const auto at = [&](double time) { return shear_statistics(history, time); };
  const auto a = at(1), b = at(3);
  for (const double weight : {0.2, 0.5, 0.9}) {
    const auto between = at(1 + 2 * weight);
    EXPECT_NEAR(between.mean, a.mean + weight * (b.mean - a.mean), 1e-14);
    EXPECT_NEAR(between.first_moment, a.first_moment + weight * (b.first_moment - a.first_moment),
                1e-14);
  }
}

TEST(StrainProjection, OneColumnTakesTheLateralAverage) {
  const auto history = riding_history();
  const StrainProjection projection(history, history.channel(channel_name::shear), {0, 4}, {0, 2},
                                    hat_averages(history.grid.z_nodes, history.grid.z_nodes));
  std::vector<double> field;
  projection.evaluate(0.7, field);
  ASSERT_EQ(field.size(), history.grid.z_nodes.size());
  double mean = 0;
  for (std::size_t k = 0; k < field.size(); ++k) {
    const auto& z = history.grid.z_nodes;
    const double below = k == 0 ? 0 : z[k] - z[k - 1];
    const double above = k + 1 == z.size() ? 0 : z[k + 1] - z[k];
    mean += 0.5 * (below + above) * field[k];
  }
  EXPECT_NEAR(mean, shear_statistics(history, 0.7).mean, 1e-14);
}

} // namespace
} // namespace ionskin::history
