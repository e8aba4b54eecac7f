// SPDX-License-Identifier: Apache-2.0
#include "condensed_line.hpp"
#include "ionskin/mechanics/engine/position_nodes.hpp"
#include "largest_difference.hpp"
#include "small_case.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

namespace ionskin::mechanics {
namespace {

TEST(PositionNodes, that_mirror_each_other_are_expected_as_one_place) {
  const Case input = small_case();
  const auto at = [&](double x, double y) {
    return std::array<double, 2>{x * input.skin.length, y * input.skin.width};
  };
  const MotionBox central{at(0.3, 0.4), at(0.7, 0.6)}, aside{at(0.1, 0.1), at(0.4, 0.3)};
  const auto count = [&](const MotionBox& box) {
    const auto counts = expected_counts(input, box);
    return counts[0] * counts[1];
  };
  EXPECT_EQ(4 * expected_places(input, central), count(central));
  EXPECT_EQ(expected_places(input, aside), count(aside));
}

TEST(PositionNodes, give_the_skin_at_places_that_were_not_solved) {
  const double tolerance = node_tolerance(line().input, {{1.5e-3, 1e-3}, {3.5e-3, 1e-3}});
  EXPECT_LE(line().nodes->error(), tolerance);
  EXPECT_LT(line().nodes->compliance().modes(), line().nodes->count());
  CellVector force(3 * line().model->cells.count());
  for (std::size_t i = 0; i < force.size(); ++i) {
    force[i] = i % 3 == 0 ? 1 : i % 3 == 1 ? 0.3 : 0;
  }
  for (const double x : {1.63e-3, 2.2e-3, 3.41e-3}) {
    const CondensedPosition direct(*line().model, {x, 1e-3});
    linear_algebra::DenseMatrix compliance;
    line().nodes->compliance().at({x, 1e-3}, compliance);
    EXPECT_LT(largest_difference(compliance.values, direct.compliance().values), tolerance) << x;
    const auto strain = line().nodes->respond({{x, 1e-3}}, {force}).front().strain;
    const auto expected = direct.strain(direct.respond({force}).front());
    ASSERT_EQ(strain.points, expected.points);
    EXPECT_LT(largest_difference(strain.component[4], expected.component[4]), tolerance) << x;
  }
}

TEST(PositionNodes, leave_a_skin_at_rest_that_carries_no_load) {
  const CellVector none(3 * line().model->cells.count());
  const auto responses = line().nodes->respond({{2.2e-3, 1e-3}, {2.3e-3, 1e-3}}, {none, none});
  for (const StateResponse& response : responses) {
    EXPECT_EQ(*std::ranges::max_element(response.strain.component[4]), 0);
    EXPECT_EQ(response.equilibrium_residual, 0);
  }
}

TEST(PositionNodes, share_places_that_mirror_each_other) {
  Case input = small_case(); // 5 mm long
  const auto model = std::make_shared<const SkinModel>(input, mesh::largest_footprint(input));
  const base::ProgressCallback none = base::no_progress;
  parallel::SharedProgress progress("mechanics", none);
  const PositionNodes nodes(input, model, {{1.5e-3, 1e-3}, {3.5e-3, 1e-3}},
                            NodeOptions{.threads = 2, .cache = nullptr, .count = 2}, progress);
  linear_algebra::DenseMatrix compliance;
  nodes.compliance().at({3.5e-3, 1e-3}, compliance);
  EXPECT_LT(largest_difference(compliance.values,
                               CondensedPosition(*model, {3.5e-3, 1e-3}).compliance().values),
            1e-9);
}

TEST(PositionNodes, respond_to_many_states_as_to_each_of_them) {
  std::vector<std::array<double, 2>> places;
  std::vector<CellVector> forces;
  for (int k = 0; k <= 20; ++k) {
    const double part = 0.05 * k;
    places.push_back({1.5e-3 + 2e-3 * part, 1e-3});
    CellVector& force = forces.emplace_back(3 * line().model->cells.count());
    for (std::size_t i = 0; i < force.size(); ++i) {
      const double at = static_cast<double>(i) / static_cast<double>(force.size());
      force[i] = (i % 3 == 0 ? 1 : i % 3 == 1 ? 0.3 * part : 0) * (1 + std::sin(3 * at + part));
    }
  }
  const auto together = line().nodes->respond(places, forces);
  const double tolerance = node_tolerance(line().input, {{1.5e-3, 1e-3}, {3.5e-3, 1e-3}});
  for (std::size_t k = 0; k < places.size(); ++k) {
    const auto alone = line().nodes->respond({places[k]}, {forces[k]}).front();
    EXPECT_LT(largest_difference(together[k].strain.component[4], alone.strain.component[4]),
              0.1 * tolerance)
        << k;
    EXPECT_LT(largest_difference(together[k].electrode_stress, alone.electrode_stress),
              10 * tolerance)
        << k;
    EXPECT_LT(together[k].equilibrium_residual, 1e-9);
  }
}

TEST(PositionNodes, solve_paths_together_as_each_of_them) {
  const PositionNodes& nodes = *line().nodes;
  const auto path = [&](double first) {
    std::vector<std::array<double, 2>> places;
    std::vector<CellVector> forces;
    for (int k = 0; k < 5; ++k) {
      places.push_back({first + 2e-4 * k, 1e-3});
      forces.emplace_back(3 * line().model->cells.count(), 1.0 + k)[3] = first;
    }
    return nodes.patterns(places, forces);
  };
  PathResponse one = path(1.6e-3), other = path(2.3e-3), alone = path(2.3e-3);
  int positions = 0;
  nodes.solve({&one, &other}, [&] { ++positions; });
  EXPECT_EQ(positions, static_cast<int>(nodes.places()));
  nodes.solve({&alone});
  EXPECT_GT(other.bytes(), 0u);
  const auto found = other.states(1, 3, 2), expected = alone.states(1, 3, 1);
  for (std::size_t k = 0; k < found.size(); ++k) {
    EXPECT_EQ(found[k].strain.component, expected[k].strain.component);
    EXPECT_EQ(found[k].electrode_stress, expected[k].electrode_stress);
    EXPECT_GT(*std::ranges::max_element(found[k].strain.component[2]), 0);
  }
}

TEST(PositionNodes, pass_on_what_is_no_number) {
  CellVector force(3 * line().model->cells.count(), 1.0);
  force[0] = std::nan("");
  const auto response = line().nodes->respond({{2e-3, 1e-3}}, {force}).front();
  EXPECT_TRUE(std::isnan(response.equilibrium_residual));
  ASSERT_FALSE(response.electrode_stress.empty());
  EXPECT_TRUE(std::isnan(response.electrode_stress.front()));
}

TEST(PositionNodes, respond_across_their_line_at_its_ends) {
  const base::ProgressCallback none = base::no_progress;
  parallel::SharedProgress progress("mechanics", none);
  NodeOptions options{.threads = 2};
  options.across_at_ends = true;
  const PositionNodes nodes(line().input, line().model, {{1.5e-3, 1e-3}, {3.5e-3, 1e-3}}, options,
                            progress);
  CellVector force(3 * line().model->cells.count());
  for (std::size_t i = 0; i < force.size(); ++i) {
    force[i] = i % 3 == 0 ? 1 : i % 3 == 1 ? 0.2 : 0.1 * std::sin(static_cast<double>(i));
  }
  for (const double x : {1.5e-3, 3.5e-3}) {
    const CondensedPosition direct(*line().model, {x, 1e-3});
    EXPECT_LT(largest_difference(nodes.respond({{x, 1e-3}}, {force}).front().strain.component[5],
                                 direct.strain(direct.respond({force}).front()).component[5]),
              1e-9)
        << x;
  }
  for (std::size_t i = 2; i < force.size(); i += 3) {
    force[i] = 0; // as where all slips along the line
  }
  EXPECT_EQ(nodes.respond({{2.2e-3, 1e-3}}, {force}).front().strain.component,
            line().nodes->respond({{2.2e-3, 1e-3}}, {force}).front().strain.component);
}

TEST(PositionNodes, are_loaded_across_at_the_ends_alone_where_nothing_sticks_between) {
  const auto at_ends = [](const Case& input) {
    return loads_across_at_ends(input, *contact_box(input));
  };
  Case input = small_case();
  EXPECT_TRUE(at_ends(input));
  input.motion.kind = MotionKind::reciprocating;
  input.motion.strokes = 3;
  input.motion.dwell = 0.1;
  EXPECT_TRUE(at_ends(input));
  input.motion.drive.stiffness = 100;
  EXPECT_FALSE(at_ends(input)) << "a slider on a drive may stick anywhere";
  Case rows = small_case();
  rows.motion.kind = MotionKind::waypoints;
  const auto path = [&](double back, double height) {
    rows.motion.waypoints = {{0, {1.5e-3, 1e-3}, 1e-3, {}},   {0.5, {1.5e-3, 1e-3}, -1e-6, {}},
                             {1, {2.5e-3, 1e-3}, height, {}}, {2, {3.5e-3, 1e-3}, height, {}},
                             {3, {back, 1e-3}, height, {}},   {4, {back, 1e-3}, 1e-3, {}}};
    return rows;
  };
  EXPECT_TRUE(at_ends(path(1.5e-3, -1e-6)));
  EXPECT_FALSE(at_ends(path(1.6e-3, -1e-6))) << "it halts on the way";
  EXPECT_FALSE(at_ends(path(1.5e-3, -2e-6))) << "its load changes on the way";
}

} // namespace
} // namespace ionskin::mechanics
