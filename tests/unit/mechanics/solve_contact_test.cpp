// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/solve_contact.hpp"

#include "ionskin/mechanics/elasticity/core_strain.hpp"
#include "ionskin/mechanics/path/contact_plan.hpp"
#include "ionskin/mechanics/path/slider_track.hpp"
#include "ionskin/mechanics/position/condensed_position.hpp"
#include "ionskin/mechanics/position/interpolation_error.hpp"
#include "ionskin/mechanics/position/interpolation_nodes.hpp"
#include "small_case.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace ionskin::mechanics {
namespace {

ContactSolution solve(const Case& input, ContactOptions options = {}) {
  base::Timers timers;
  options.threads = 2;
  return solve_contact(input, options, timers);
}

/// Solved once for all tests that only look at it.
const ContactSolution& solved_small_case() {
  static const ContactSolution solution = solve(small_case());
  return solution;
}

const ContactState& touchdown(const ContactSolution& solution) {
  return *solution.legs[0].last();
}
const LegSolution& slide(const ContactSolution& solution) {
  return solution.legs[1];
}
const LegSolution& lift_off(const ContactSolution& solution) {
  return solution.legs[2];
}

void expect_same_bits(const ContactSolution& one, const ContactSolution& other) {
  ASSERT_EQ(one.legs.size(), other.legs.size());
  for (std::size_t leg = 0; leg < one.legs.size(); ++leg) {
    for (const auto points : {&LegSolution::path, &LegSolution::steady}) {
      const auto &first = one.legs[leg].*points, &second = other.legs[leg].*points;
      ASSERT_EQ(first.size(), second.size());
      for (std::size_t i = 0; i < first.size(); ++i) {
        ASSERT_EQ(first[i].time, second[i].time);
        ASSERT_EQ(!first[i].state, !second[i].state);
        if (first[i].state) {
          EXPECT_EQ(first[i].state->normal_traction, second[i].state->normal_traction);
          EXPECT_EQ(first[i].state->strain.component, second[i].state->strain.component);
        }
      }
    }
  }
}

double total_friction(const ContactState& state) {
  return std::hypot(state.tangential_force[0], state.tangential_force[1]);
}

TEST(SolveContact, path_goes_from_touchdown_through_steady_sliding_to_nothing) {
  const ContactSolution& solution = solved_small_case();
  EXPECT_GT(touchdown(solution).normal_force, 1.0);
  EXPECT_EQ(slide(solution).path.size(), 31u);
  EXPECT_EQ(slide(solution).steady.size(), 8u);
  EXPECT_LT(solution.worst_interpolation_error, interpolation_tolerance(Preset::coarse));
  for (const PathState& point : slide(solution).steady) {
    EXPECT_NEAR(total_friction(*point.state), 0.3 * point.state->normal_force,
                1e-8 * point.state->normal_force);
    EXPECT_EQ(point.state->stick_fraction, 0.0);
  }
  EXPECT_NEAR(lift_off(solution).path.back().time, 0.5 / 1001, 1e-15);
  EXPECT_NEAR(lift_off(solution).last()->normal_force, 0, 1e-12);
  EXPECT_FALSE(solution.legs[3].in_contact());
  EXPECT_LT(solution.worst_equilibrium_residual, 1e-9);
  EXPECT_LT(solution.worst_complementarity_residual, 1e-8);
}

TEST(SolveContact, onset_joins_steady_sliding) {
  const ContactSolution& solution = solved_small_case();
  const ContactState &last = *slide(solution).path.back().state,
                     &steady = *slide(solution).steady.front().state;
  EXPECT_NEAR(last.normal_force, steady.normal_force, 1e-5 * steady.normal_force);
  const auto &a = last.strain.component[4], &b = steady.strain.component[4];
  double difference = 0, size = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    difference = std::max(difference, std::abs(a[i] - b[i]));
    size = std::max(size, std::abs(b[i]));
  }
  EXPECT_LT(difference, 1e-5 * size);
}

TEST(SolveContact, reflected_nodes_agree_with_their_own_factorisation) {
  const Case input = small_case();
  const ContactSolution& solution = solved_small_case();
  // Shares the factorisation of the first node.
  const ContactState& last = *slide(solution).steady.back().state;
  base::Timers timers;
  const ContactState direct =
      solve_steady_sliding(input, {input.motion.stroke}, ContactOptions{}, timers).front();
  EXPECT_NEAR(last.normal_force, direct.normal_force, 1e-9 * direct.normal_force);
  EXPECT_NEAR(last.tangential_force[0], direct.tangential_force[0], 1e-9 * direct.normal_force);
  for (std::size_t i = 0; i < direct.normal_traction.size(); ++i) {
    EXPECT_NEAR(last.normal_traction[i], direct.normal_traction[i], 1e-2);
  }
  for (int c = 0; c < 6; ++c) {
    const auto &a = last.strain.component[c], &b = direct.strain.component[c];
    for (std::size_t i = 0; i < a.size(); ++i) {
      ASSERT_NEAR(a[i], b[i], 1e-10) << c;
    }
  }
}

TEST(SolveContact, touchdown_in_one_increment_is_exact) {
  const Case input = small_case();
  const SkinModel model(input, mesh::largest_footprint(input));
  const CondensedPosition position(model, input.slider.start);
  const ContactProblem problem{position.compliance(), model.cells.area, model.gap,
                               laws::friction("coulomb", 0.3, {})};
  const PathSteps steps;
  ContactPath path(problem, steps, 0.5);
  path.start_detached();
  ASSERT_EQ(path.follow(motion_legs(input.motion, input.slider)[0], {}).points.size(), 1u);
  const SurfaceState& once = path.state();
  SurfaceState stepped{CellVector(once.force.size()), CellVector(once.force.size()), {}, {}};
  for (int i = 1; i <= 4; ++i) {
    const SliderStep step{
        {LoadKind::indentation, input.motion.preload * i / 4}, {0, 0}, 0.1, stepped.surface};
    stepped = solve_contact_step(problem, step, stepped.force);
  }
  const double sum = std::accumulate(once.force.begin(), once.force.end(), 0.0);
  for (std::size_t i = 0; i < once.force.size(); ++i) {
    EXPECT_NEAR(once.force[i], stepped.force[i], 1e-7 * sum);
  }
}

TEST(SolveContact, a_second_cycle_repeats_the_first) {
  const ContactSolution& first = solved_small_case();
  ContactOptions options;
  options.surface_before = first.final_surface;
  const ContactSolution second = solve(small_case(), options);
  EXPECT_NEAR(touchdown(second).normal_force, touchdown(first).normal_force,
              1e-10 * touchdown(first).normal_force);
  for (std::size_t i = 1; i < slide(first).path.size(); ++i) {
    EXPECT_NEAR(slide(second).path[i].state->tangential_force[0],
                slide(first).path[i].state->tangential_force[0],
                1e-8 * touchdown(first).normal_force);
  }
}

TEST(SolveContact, without_friction_nothing_drags) {
  Case input = small_case();
  input.contact.friction = 0;
  const ContactSolution solution = solve(input);
  EXPECT_TRUE(slide(solution).path.empty());
  EXPECT_NEAR(slide(solution).steady.front().state->normal_force, touchdown(solution).normal_force,
              1e-8 * touchdown(solution).normal_force);
  EXPECT_EQ(total_friction(*slide(solution).steady.front().state), 0.0);
}

TEST(SolveContact, press_and_hold_lifts_off_where_it_touched_down) {
  Case input = small_case();
  input.motion.stroke = 0;
  const ContactSolution solution = solve(input);
  EXPECT_EQ(slide(solution).path.size(), 1u);
  EXPECT_TRUE(slide(solution).steady.empty());
  ASSERT_EQ(lift_off(solution).path.size(), 21u);
  // Unloading nearly retraces the loading; only a rim of reversed slip differs.
  EXPECT_NEAR(lift_off(solution).path[10].state->normal_force,
              0.5 * touchdown(solution).normal_force, 5e-3 * touchdown(solution).normal_force);
}

TEST(SolveContact, a_short_stroke_ends_before_full_sliding_and_says_so) {
  Case input = small_case();
  input.motion.stroke = 2e-7;
  const ContactSolution solution = solve(input);
  EXPECT_TRUE(slide(solution).steady.empty());
  EXPECT_EQ(solution.warnings.size(), 1u);
  EXPECT_DOUBLE_EQ(slide(solution).path.back().time, input.motion.slide);
  EXPECT_GT(slide(solution).last()->stick_fraction, 0.0);
  EXPECT_EQ(lift_off(solution).path.size(), 21u);
}

TEST(SolveContact, oblique_tracks_use_the_full_model) {
  Case input = small_case();
  input.motion.direction = {0.8, 0.6};
  input.motion.stroke = 0.5e-3;
  input.slider.start = {2.3e-3, 0.85e-3}; // symmetric about the middle of the skin
  const ContactSolution solution = solve(input);
  EXPECT_FALSE(solution.mesh.half_model());
  const ContactState &first = *slide(solution).steady.front().state,
                     &last = *slide(solution).steady.back().state;
  EXPECT_NEAR(first.tangential_force[0], 0.8 * 0.3 * first.normal_force, 1e-8 * first.normal_force);
  EXPECT_NEAR(first.tangential_force[1], 0.6 * 0.3 * first.normal_force, 1e-8 * first.normal_force);
  EXPECT_GT(std::abs(first.normal_force / last.normal_force - 1),
            1e-6); // leading and trailing differ
  EXPECT_LT(solution.worst_equilibrium_residual, 1e-9);
}

TEST(SolveContact, half_and_full_model_agree) {
  Case input = small_case();
  input.motion.stroke = 0;
  ContactOptions options;
  options.full_model = true;
  const ContactState half = touchdown(solve(input)), full = touchdown(solve(input, options));
  EXPECT_NEAR(half.normal_force, full.normal_force, 1e-9 * full.normal_force);
}

TEST(SolveContact, a_stroke_back_starts_from_sliding_forth) {
  Case input = small_case();
  input.motion.kind = MotionKind::reciprocating;
  input.motion.strokes = 3;
  input.motion.dwell = 0.1;
  ContactOptions options;
  options.nodes = 3;
  const ContactSolution solution = solve(input, options);
  const LegSolution &forth = solution.legs[1], &rest = solution.legs[2], &back = solution.legs[3];
  EXPECT_EQ(rest.last(), forth.last());
  EXPECT_EQ(back.path.front().state, forth.last());
  // It sticks at first and ends in sliding the other way.
  EXPECT_GT(back.path[1].state->stick_fraction, 0.9);
  const ContactState &last = *back.path.back().state, &steady = *back.steady.front().state;
  EXPECT_NEAR(last.tangential_force[0], steady.tangential_force[0], 1e-5 * steady.normal_force);
  EXPECT_NEAR(steady.tangential_force[0], -0.3 * steady.normal_force, 1e-8 * steady.normal_force);
  // The skin is symmetric about its middle, and the third stroke repeats the first.
  EXPECT_NEAR(steady.normal_force, forth.steady.front().state->normal_force,
              1e-8 * steady.normal_force);
  EXPECT_EQ(solution.legs[5].steady.front().state, forth.steady.front().state);
  EXPECT_EQ(plan_contact(input, NodeCounts(solution.legs.size(), 3)).positions.size(), 2u);
}

TEST(SolveContact, a_friction_coefficient_is_solved_the_same_beside_others) {
  const Case input = small_case();
  base::Timers timers;
  ContactOptions options;
  options.threads = 2;
  const std::vector<ContactSolution> together =
      solve_contact(input, std::vector<double>{0.0, 0.3, 0.6}, options, timers);
  expect_same_bits(together[1], solved_small_case());
}

TEST(SolveContact, a_round_slider_is_solved_the_same_beside_larger_frictions) {
  Case input = small_case();
  input.slider.shape = "sphere";
  input.slider.parameters["radius"] = 8e-3;
  input.motion.preload = 0;
  input.motion.preload_force = 0.2;
  input.contact.friction = 0.1;
  base::Timers timers;
  ContactOptions options;
  options.threads = 2;
  const auto together = solve_contact(input, std::vector<double>{0.8, 0.1, 0.4}, options, timers);
  expect_same_bits(together[1], solve(input));
}

TEST(SolveContact, steady_sliding_between_the_nodes_is_as_close_as_estimated) {
  const Case input = small_case();
  const std::vector<PathState>& nodes = slide(solved_small_case()).steady;
  base::Timers timers;
  ContactOptions options;
  options.threads = 2;
  for (const double fraction : {0.02, 0.13, 0.71}) {
    const ContactState direct =
        solve_steady_sliding(input, {fraction * input.motion.stroke}, options, timers).front();
    const auto weights = interpolation_weights(nodes, fraction * input.motion.slide);
    double difference = 0, size = 0;
    for (std::size_t c = 0; c < 6; ++c) {
      for (std::size_t i = 0; i < direct.strain.component[c].size(); ++i) {
        double value = -direct.strain.component[c][i];
        size += value * value;
        for (std::size_t node = 0; node < nodes.size(); ++node) {
          value += weights[node] * nodes[node].state->strain.component[c][i];
        }
        difference += value * value;
      }
    }
    EXPECT_LT(std::sqrt(difference / size), solved_small_case().worst_interpolation_error);
  }
}

TEST(SolveContact, a_force_is_held_with_the_indentation_free) {
  Case input = small_case();
  input.motion.preload = 0;
  input.motion.preload_force = 1;
  ContactOptions options;
  options.nodes = 3;
  const ContactSolution solution = solve(input, options);
  for (const auto* path : {&slide(solution).path, &slide(solution).steady}) {
    for (const PathState& point : *path) {
      EXPECT_NEAR(point.state->normal_force, 1, 1e-9);
    }
  }
  EXPECT_GT(touchdown(solution).indentation, 1e-9);
  // Held at the indentation that the slide ends with, the slider presses with the same force; the
  // lift-off starts from there.
  const double indentation = slide(solution).last()->indentation;
  Case held = input;
  held.motion.preload_force = 0;
  held.motion.preload = indentation;
  base::Timers timers;
  EXPECT_NEAR(
      solve_steady_sliding(held, {held.motion.stroke}, options, timers).front().normal_force, 1,
      1e-8);
  EXPECT_NEAR(lift_off(solution).path[10].state->indentation, 0.5 * indentation,
              1e-12 * indentation);
  EXPECT_NEAR(lift_off(solution).last()->normal_force, 0, 1e-12);
}

TEST(SolveContact, a_path_may_land_and_leave_on_the_way) {
  Case input = small_case();
  input.motion.kind = MotionKind::waypoints;
  input.motion.waypoints = {{0, {1.5e-3, 1e-3}, 1e-6, {}},
                            {1, {2.0e-3, 1e-3}, -1e-6, {}},
                            {2, {3.0e-3, 1e-3}, -1e-6, {}},
                            {3, {3.5e-3, 1e-3}, 1e-6, {}}};
  ContactOptions options;
  options.nodes = 3;
  const ContactSolution solution = solve(input, options);
  const auto at = [&](double time) {
    return std::ranges::find_if(solution.stepped, [&](const SteppedInstant& instant) {
      return std::abs(instant.time - time) < 1e-12;
    });
  };
  ASSERT_NE(at(0.5), solution.stepped.end());
  EXPECT_EQ(at(0.5)->state, nullptr);
  ASSERT_NE(at(1.0), solution.stepped.end());
  // Slides from the first, and on in the same direction.
  EXPECT_EQ(at(1.0)->state->stick_fraction, 0);
  EXPECT_NEAR(at(1.0)->state->tangential_force[0], 0.3 * at(1.0)->state->normal_force,
              1e-8 * at(1.0)->state->normal_force);
  ASSERT_NE(at(2.5), solution.stepped.end());
  EXPECT_EQ(at(2.5)->state, nullptr);
  EXPECT_EQ(solution.stepped.back().state, nullptr);
  EXPECT_EQ(solution.stepped_events.front(), 0.5);
  EXPECT_EQ(solution.stepped_events.back(), 2.5);
}

TEST(SolveContact, plane_strain_with_symmetric_sides) {
  Case input = small_case();
  input.skin.sides = SideCondition::symmetry;
  input.slider.size[1] = 3e-3;
  const ContactSolution solution = solve(input);
  const ContactState& state = *slide(solution).steady.front().state;
  EXPECT_NEAR(state.tangential_force[0], 0.3 * state.normal_force, 1e-8 * state.normal_force);
  for (const int c : {1, 3, 5}) { // yy, yz, xy
    for (const double value : state.strain.component[c]) {
      ASSERT_NEAR(value, 0, 1e-12);
    }
  }
  EXPECT_LT(solution.worst_complementarity_residual, 1e-8);
}

TEST(SolveContact, a_contact_at_the_border_widens_its_own_mesh_only) {
  Case input = small_case();
  input.slider.shape = "sphere";
  input.slider.parameters["radius"] = 8e-3;
  input.motion.preload = 0;
  input.motion.preload_force = 0.2;
  ContactOptions options;
  options.threads = 2;
  // The contact reaches its border under the larger friction, which drags it along, only.
  constexpr double tight = 1.15e-4;
  options.footprint = mesh::Footprint{{tight, tight}, {tight, tight}};
  base::Timers timers;
  const auto both = solve_contact(input, {0.02, 0.6}, options, timers);
  EXPECT_DOUBLE_EQ(both[0].cell_lines_x.back(), tight);
  EXPECT_GT(both[1].cell_lines_x.back(), 1.2 * tight);
  const auto alone = solve_contact(input, {0.02}, options, timers);
  EXPECT_EQ(touchdown(both[0]).normal_traction, touchdown(alone[0]).normal_traction);
}

} // namespace
} // namespace ionskin::mechanics
