// SPDX-License-Identifier: Apache-2.0
#include "ionskin/electrochemistry/grid/transport_grid.hpp"

#include "ionskin/electrochemistry/grid/scaled_grid.hpp"
#include "ionskin/electrochemistry/ion_transport.hpp"
#include "model_cases.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>
#include <numeric>

namespace ionskin::electrochemistry {
namespace {

TEST(GradedNodes, AreSymmetricAndGrowGently) {
  const GridResolution resolution = grid_resolution(Preset::standard);
  const auto nodes = graded_nodes(180e-6, 0.66e-6, resolution);
  EXPECT_EQ(nodes.front(), 0.0);
  EXPECT_EQ(nodes.back(), 180e-6);
  EXPECT_NEAR(nodes[1], resolution.wall_cell * 0.66e-6, 1e-18);
  for (std::size_t i = 1; i + 1 < nodes.size(); ++i) {
    const double ratio = (nodes[i + 1] - nodes[i]) / (nodes[i] - nodes[i - 1]);
    EXPECT_LT(ratio, resolution.bulk_growth + 1e-9);
    EXPECT_GT(ratio, 1.0 / resolution.bulk_growth - 1e-9);
    EXPECT_NEAR(nodes[i], 180e-6 - nodes[nodes.size() - 1 - i], 1e-18);
  }
}

TEST(GradedNodes, StayAscendingForThinAndThickCores) {
  for (const double thickness : {0.2, 1.0, 3.0, 10.0, 100.0, 1e5}) {
    const auto nodes = graded_nodes(thickness, 1.0, grid_resolution(Preset::coarse));
    for (std::size_t i = 1; i < nodes.size(); ++i) {
      EXPECT_GT(nodes[i], nodes[i - 1]) << thickness;
    }
    EXPECT_EQ(nodes.back(), thickness);
  }
}

TEST(GradedNodes, RefinementMultipliesTheLevels) {
  const GridResolution resolution = grid_resolution(Preset::standard);
  const auto once = graded_nodes(180e-6, 0.66e-6, resolution);
  const auto twice = graded_nodes(180e-6, 0.66e-6, refined(resolution, 2.0));
  EXPECT_NEAR(static_cast<double>(twice.size()) / static_cast<double>(once.size()), 2.0, 0.15);
}

TEST(TransportGrid, BaselineHas75By10Columns) {
  const auto grid =
      make_transport_grid(verification::model_case(), verification::sliding_contact_history(1));
  EXPECT_EQ(grid.x_edges.size(), 76U);
  EXPECT_EQ(grid.y_edges.size(), 11U);
}

TEST(TransportGrid, HalfTheWidthIsWholeColumns) {
  Case input = verification::model_case();
  for (const double refinement : {0.5, 0.7, 1.0, 1.3, 1.5, 2.0}) {
    input.numerics.mesh_refinement = refinement;
    const auto grid = make_transport_grid(input, verification::sliding_contact_history(1));
    EXPECT_EQ((grid.y_edges.size() - 1) % 2, 0U) << refinement;
  }
}

TEST(TransportGrid, UniformHistoryGetsOneColumn) {
  Case input = verification::model_case();
  input.numerics.mesh_refinement = 2.0;
  const auto grid =
      make_transport_grid(input, verification::linear_step_history(0.0, 1.0, {0.0, 1.0}));
  EXPECT_EQ(grid.x_edges.size(), 2U);
  EXPECT_EQ(grid.y_edges.size(), 2U);
}

TEST(TransportGrid, PresetsAndRefinementOrderTheSizes) {
  const auto history = verification::sliding_contact_history(1);
  Case input = verification::model_case();
  const auto levels = [&](Preset preset, double refinement) {
    input.numerics = {preset, refinement, 1.0};
    const auto grid = make_transport_grid(input, history);
    return grid.z_nodes.size() * (grid.x_edges.size() - 1) * (grid.y_edges.size() - 1);
  };
  EXPECT_LT(levels(Preset::coarse, 1.0), levels(Preset::standard, 1.0));
  EXPECT_LT(levels(Preset::standard, 1.0), levels(Preset::fine, 1.0));
  EXPECT_GT(levels(Preset::standard, 2.0), 6 * levels(Preset::standard, 1.0));
  EXPECT_LT(levels(Preset::standard, 0.5), levels(Preset::standard, 1.0));
}

TEST(TransportGrid, ColumnsEndAtTheEdgesOfTaxels) {
  EXPECT_EQ(aligned_column_count(49, 1, {}), 49U);
  EXPECT_EQ(aligned_column_count(49, 1, {0, 0.25, 0.5, 1}), 52U);
  EXPECT_EQ(aligned_column_count(8, 2, {1.0 / 3}), 12U);
  EXPECT_EQ(aligned_column_count(10, 1, {0.1}), 10U);
  // No number fits an irrational edge; a near one is taken, within half as many again.
  const std::size_t near = aligned_column_count(49, 1, {std::sqrt(0.5)});
  EXPECT_LT(near, 75U);
  const double at = std::sqrt(0.5) * static_cast<double>(near);
  EXPECT_LT(std::abs(at - std::round(at)), 0.1);
}

TEST(TransportGrid, ChargesOfTaxelsAreThoseOfAFineGrid) {
  Case input = verification::model_case();
  input.numerics.preset = Preset::coarse;
  input.readout.taxels = {{"a", {0, 0}, {4.5e-3, 2e-3}}, {"b", {4.5e-3, 0}, {15e-3, 2e-3}}};
  history::CoreHistory history = verification::linear_step_history(0.0, 0.01, {0.0, 0.01});
  // Shear on the taxel b alone, up to its edge.
  history.grid.x_edges = {0, 4.5e-3, 6.5e-3, 15e-3};
  history.grid.y_edges = {0, 2e-3};
  for (auto& sample : history.shear()) {
    history::StrainField field;
    for (const double value : *sample) {
      field.insert(field.end(), {0, value, 0});
    }
    sample = std::make_shared<const history::StrainField>(std::move(field));
  }
  const auto charges = [&](double refinement) {
    input.numerics.mesh_refinement = refinement;
    base::Timers timers;
    const IonSolution solution = solve_ion_transport(input, history, {}, timers);
    return std::array{solution.top_segments[0].charge.back(),
                      solution.top_segments[1].charge.back()};
  };
  const auto coarse = charges(1), fine = charges(3);
  EXPECT_NEAR(coarse[0], fine[0], 0.01 * std::abs(fine[1]));
  EXPECT_NEAR(coarse[1], fine[1], 0.01 * std::abs(fine[1]));
}

TEST(ScaledGrid, ControlVolumesFillTheCore) {
  const ScaledGrid grid = scale_grid({{0, 1, 2}, {0, 3}, {0, 0.5, 2.0, 4.0}}, 0.5);
  EXPECT_DOUBLE_EQ(std::accumulate(grid.height.begin(), grid.height.end(), 0.0), 8.0);
  EXPECT_DOUBLE_EQ(grid.thickness, 8.0);
  EXPECT_DOUBLE_EQ(grid.coupling_x, 0.25);
  EXPECT_DOUBLE_EQ(grid.coupling_y, 0.0);
  EXPECT_DOUBLE_EQ(grid.position.back(), 1.0);
}

TEST(ChargeWeights, ConserveTheChargeOfEveryLevel) {
  const ScaledGrid grid = scale_grid({{0, 1}, {0, 1}, {0, 0.1, 0.3, 0.8, 3.0, 20.0, 40.0}}, 1.0);
  for (std::size_t k = 0; k < grid.levels; ++k) {
    double counted = charge_weights(grid, k).here;
    if (k > 0) {
      counted += charge_weights(grid, k - 1).above;
    }
    if (k + 1 < grid.levels) {
      counted += charge_weights(grid, k + 1).below;
    }
    EXPECT_NEAR(counted, grid.height[k], 1e-15);
  }
}

} // namespace
} // namespace ionskin::electrochemistry
