// SPDX-License-Identifier: Apache-2.0
#include "ionskin/base/error.hpp"
#include "ionskin/mechanics/engine/kept_path.hpp"
#include "ionskin/mechanics/engine/motion_stepper.hpp"
#include "ionskin/mechanics/engine/path_thinning.hpp"
#include "ionskin/mechanics/engine/position_nodes.hpp"
#include "ionskin/mechanics/path/find_footprint.hpp"
#include "ionskin/mechanics/solve_contact.hpp"
#include "ionskin/mechanics/solve_stepped.hpp"
#include "ionskin/mechanics/surface/contact_diagnostics.hpp"
#include "small_case.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <memory>
#include <random>
#include <string>

namespace ionskin::mechanics {
namespace {

/// The skin of the small case condensed for a line of slider positions, once for all tests.
struct Line {
  Case input = small_case();
  std::shared_ptr<const SkinModel> model;
  std::unique_ptr<const PositionNodes> nodes;

  Line() {
    input.skin.length = 7.3e-3; // no place mirrors another
    model = std::make_shared<const SkinModel>(input, mesh::largest_footprint(input));
    const base::ProgressCallback none = base::no_progress;
    parallel::SharedProgress progress("mechanics", none);
    nodes = std::make_unique<const PositionNodes>(input, model,
                                                  MotionBox{{1.5e-3, 1e-3}, {3.5e-3, 1e-3}},
                                                  NodeOptions{.threads = 2}, progress);
  }
  SlidingContact slider(const laws::Friction& friction = laws::friction("coulomb", 0.3, {})) const {
    return {nodes->compliance(), model->cells.area, model->gap, friction};
  }
};

const Line& line() {
  static const Line line;
  return line;
}

double difference(const std::vector<double>& a, const std::vector<double>& b) {
  double worst = 0, scale = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    worst = std::max(worst, std::abs(a[i] - b[i]));
    scale = std::max(scale, std::abs(b[i]));
  }
  return worst / scale;
}

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
    EXPECT_LT(difference(compliance.values, direct.compliance().values), tolerance) << x;
    const auto strain = line().nodes->respond({{x, 1e-3}}, {force}).front().strain;
    const auto expected = direct.respond({force}).front().strain;
    ASSERT_EQ(strain.points, expected.points);
    EXPECT_LT(difference(strain.component[4], expected.component[4]), tolerance) << x;
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
  EXPECT_LT(
      difference(compliance.values, CondensedPosition(*model, {3.5e-3, 1e-3}).compliance().values),
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
    EXPECT_LT(difference(together[k].strain.component[4], alone.strain.component[4]),
              0.1 * tolerance)
        << k;
    EXPECT_LT(difference(together[k].electrode_stress, alone.electrode_stress), 10 * tolerance)
        << k;
    EXPECT_LT(together[k].equilibrium_residual, 1e-9);
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
    EXPECT_LT(difference(nodes.respond({{x, 1e-3}}, {force}).front().strain.component[5],
                         direct.respond({force}).front().strain.component[5]),
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

TEST(SlidingContact, is_the_contact_of_single_steps) {
  SlidingContact slider = line().slider();
  slider.step(0.1, {2e-3, 1e-3}, {LoadKind::indentation, 1e-6});
  EXPECT_TRUE(slider.sticks());
  double before = 0;
  for (const double travel : {0.1e-6, 0.4e-6, 1e-6, 4e-6, 3.8e-6, 2e-6}) {
    const SurfaceState start = slider.state();
    slider.step(0.01, {2e-3 + travel, 1e-3}, {LoadKind::indentation, 1e-6});
    const SliderStep step{{LoadKind::indentation, 1e-6}, {travel - before, 0}, 0.01, start.surface};
    const SurfaceState direct = solve_contact_step(slider.problem(), step, start.force);
    EXPECT_LT(difference(slider.state().force, direct.force), 1e-7) << travel;
    before = travel;
  }
  EXPECT_EQ(slider.fallbacks(), 0);
}

TEST(SlidingContact, holds_a_force_and_leaves_without_a_trace) {
  SlidingContact slider = line().slider();
  slider.step(0.1, {2e-3, 1e-3}, {LoadKind::force, 5});
  EXPECT_NEAR(total_normal_force(slider.state().force), 5, 1e-7);
  for (int i = 1; i <= 20; ++i) {
    slider.step(0.01, {2e-3 + 5e-6 * i, 1e-3}, {LoadKind::force, 5.0 - 0.1 * i});
    EXPECT_NEAR(total_normal_force(slider.state().force), 5 - 0.1 * i, 1e-7);
  }
  EXPECT_FALSE(slider.sticks());
  EXPECT_LT(slider.factorisations(), 20); // kept while the pattern stays
  slider.step(0.01, {2.2e-3, 1e-3}, {LoadKind::indentation, -1e-6});
  EXPECT_FALSE(slider.in_contact());
  EXPECT_EQ(slider.state().surface, CellVector(slider.state().surface.size(), 0.0));
}

/// Laws of all kinds, mild and strong.
std::vector<laws::Friction> all_laws() {
  return {laws::friction("coulomb", 0.3, {}),
          laws::friction("saturating", 0.3, {{"strength", 5e5}, {"sharpness", 2}}),
          laws::friction("regularised", 0.3, {{"slip_length", 1e-6}}),
          laws::friction("regularised", 0.3, {{"slip_length", 1e-7}}),
          laws::friction("viscous", 0.3, {{"reference_speed", 0.05}}),
          laws::friction("stribeck", 0.3,
                         {{"kinetic_friction", 0.1}, {"stribeck_speed", 1e-3}, {"lag_time", 5e-3}}),
          laws::friction("anisotropic", 0.3, {{"transverse_friction", 0.1}})};
}

TEST(SlidingContact, takes_any_step_of_a_random_walk) {
  for (const laws::Friction& law : all_laws()) {
    for (const bool by_force : {false, true}) {
      SlidingContact slider = line().slider(law);
      std::mt19937 random(by_force ? 2 : 1);
      std::uniform_real_distribution<double> unit(-1, 1);
      double x = 2.5e-3, worst = 0;
      for (int i = 0; i < 100; ++i) {
        const double size = std::pow(10, -3 - 3 * std::abs(unit(random))); // 1 um to 1 mm
        x = std::clamp(x + size * unit(random), 1.5e-3, 3.5e-3);
        const double level = 0.5 + unit(random);
        const SliderLoad load = by_force ? SliderLoad{LoadKind::force, 10 * level}
                                         : SliderLoad{LoadKind::indentation, 1e-6 * level};
        const SurfaceState& state = slider.step(0.01, {x, 1e-3}, load);
        if (slider.in_contact()) {
          double largest = 0;
          for (std::size_t at = 0; at < state.force.size(); at += 3) {
            largest = std::max(largest, state.force[at]);
          }
          worst =
              std::max(worst, contact_violations(slider.problem(), state, largest, 1e-6).largest());
        }
      }
      EXPECT_LT(worst, 1e-5) << law.law;
    }
  }
}

double tangential_force(const SurfaceState& state) {
  double sum = 0;
  for (std::size_t at = 0; at < state.force.size(); at += 3) {
    sum += state.force[at + 1];
  }
  return sum;
}

/// Tangential over normal force after a slide of 0.4 mm at a constant speed.
double coefficient_at(const laws::Friction& law, double speed) {
  SlidingContact slider = line().slider(law);
  slider.step(0.1, {2e-3, 1e-3}, {LoadKind::indentation, 1e-6});
  constexpr double travel = 2e-6;
  for (int i = 1; i <= 200; ++i) {
    slider.step(travel / speed, {2e-3 + i * travel, 1e-3}, {LoadKind::indentation, 1e-6});
  }
  return tangential_force(slider.state()) / total_normal_force(slider.state().force);
}

TEST(SlidingContact, slides_with_the_coefficient_of_its_speed) {
  const auto viscous = laws::friction("viscous", 0.3, {{"reference_speed", 2e-3}});
  EXPECT_NEAR(coefficient_at(viscous, 2e-3), 0.3, 1e-4);
  EXPECT_NEAR(coefficient_at(viscous, 1e-3), 0.15, 1e-4);
  const auto stribeck = laws::friction(
      "stribeck", 0.3, {{"kinetic_friction", 0.2}, {"stribeck_speed", 1e-3}, {"lag_time", 5e-3}});
  EXPECT_NEAR(coefficient_at(stribeck, 1e-3), 0.2 + 0.1 / M_E, 1e-4);
  EXPECT_NEAR(coefficient_at(stribeck, 5e-3), 0.2, 1e-4);
  EXPECT_NEAR(coefficient_at(laws::friction("regularised", 0.3, {{"slip_length", 1e-6}}), 1e-3),
              0.3, 1e-6);
}

TEST(SlidingContact, friction_that_lags_converges_with_the_step) {
  const auto stribeck = laws::friction(
      "stribeck", 0.3, {{"kinetic_friction", 0.2}, {"stribeck_speed", 1e-3}, {"lag_time", 5e-3}});
  std::vector<double> ratio;
  for (const int steps : {20, 40, 80}) {
    SlidingContact slider = line().slider(stribeck);
    slider.step(0.1, {2e-3, 1e-3}, {LoadKind::indentation, 1e-6});
    for (int i = 1; i <= steps; ++i) { // 6 ms at 2 mm/s, all of it in the fall of friction
      slider.step(6e-3 / steps, {2e-3 + 12e-6 * i / steps, 1e-3}, {LoadKind::indentation, 1e-6});
    }
    ratio.push_back(tangential_force(slider.state()) / total_normal_force(slider.state().force));
  }
  EXPECT_GT(ratio.back(), 0.21); // not there yet
  EXPECT_LT(ratio.back(), 0.28);
  EXPECT_LT(std::abs(ratio[2] - ratio[1]), 0.7 * std::abs(ratio[1] - ratio[0]));
  EXPECT_LT(std::abs(ratio[2] - ratio[1]), 2e-3);
}

TEST(SlidingContact, elastic_slip_comes_back_in_any_number_of_steps) {
  const auto law = laws::friction("regularised", 0.3, {{"slip_length", 2e-6}});
  std::vector<double> force;
  for (const int steps : {1, 5}) {
    SlidingContact slider = line().slider(law);
    slider.step(0.1, {2e-3, 1e-3}, {LoadKind::indentation, 1e-6});
    const double start = tangential_force(slider.state());
    const auto move = [&](double from, double to) {
      for (int i = 1; i <= steps; ++i) {
        slider.step(0.1 / steps, {2e-3 + from + (to - from) * i / steps, 1e-3},
                    {LoadKind::indentation, 1e-6});
      }
      return tangential_force(slider.state());
    };
    const double forth = move(0, 0.5e-6);
    EXPECT_GT(forth, 0.03 * total_normal_force(slider.state().force));
    EXPECT_TRUE(slider.sticks());
    EXPECT_NEAR(move(0.5e-6, 0), start, 2e-3 * forth); // but for what presses beside
    force.push_back(move(0, 200e-6));
    EXPECT_FALSE(slider.sticks());
    EXPECT_NEAR(force.back(), 0.3 * total_normal_force(slider.state().force), 1e-6 * force.back());
  }
  // One long step leaves a little more of the elastic slip across the way, from landing, than five.
  EXPECT_NEAR(force[0], force[1], 1e-5 * force[0]);
}

TEST(SlidingContact, a_step_without_solution_leaves_what_friction_remembers) {
  SlidingContact slider = line().slider(laws::friction(
      "stribeck", 0.3, {{"kinetic_friction", 0.2}, {"stribeck_speed", 1e-3}, {"lag_time", 5e-3}}));
  slider.step(0.1, {2e-3, 1e-3}, {LoadKind::indentation, 1e-6});
  slider.step(0.01, {2.05e-3, 1e-3}, {LoadKind::indentation, 1e-6});
  const std::vector<double> before = slider.problem().lagged_speed;
  constexpr double no_number = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(slider.step(0.01, {2.1e-3, 1e-3}, {LoadKind::indentation, no_number}), SolverError);
  EXPECT_EQ(slider.problem().lagged_speed, before);
}

TEST(PathThinning, keeps_what_straight_lines_miss) {
  std::vector<double> kept;
  PathThinning thinning({1e-2, 1, 1, 1},
                        [&](PathThinning::Instant&& instant) { kept.push_back(instant.time); });
  for (int i = 0; i <= 100; ++i) {
    const double time = 0.01 * i;
    thinning.add({time, {0, 0}, 0, i == 20, 0, 0, {1 + std::max(0.0, time - 0.5), 0, 0}, nullptr});
  }
  thinning.finish();
  ASSERT_EQ(kept.size(), 4u); // begin, required, before the bend, end
  EXPECT_EQ(kept[1], 0.2);
  EXPECT_NEAR(kept[2], 0.51, 0.02);
  EXPECT_EQ(kept.back(), 1);
}

TEST(PathThinning, rounding_does_not_pass_the_longest_way) {
  for (const double rounding : {-1e-12, 0.0, 1e-12}) {
    int kept = 0;
    PathThinning thinning({1e-2, 1, 1, 0.1}, [&](PathThinning::Instant&&) { ++kept; });
    for (int i = 0; i <= 20; ++i) {
      thinning.add({0.1 * i, {0.05 * i * (1 + rounding), 0}, 0, false, 0, 0, {1, 0, 0}, nullptr});
    }
    thinning.finish();
    EXPECT_EQ(kept, 11);
  }
}

TEST(KeptPath, counts_a_slider_below_the_skin_without_load_as_a_violation) {
  ContactSolution solution{.mesh = line().model->mesh};
  KeptPath path(*line().nodes, nullptr, {1e-2, 1, 1, 0.1}, solution);
  const SlidingContact slider = line().slider();
  path.add({0, {2e-3, 1e-3}, 1e-3, false, true, {}}, slider);
  EXPECT_EQ(solution.worst_complementarity_residual, 0);
  path.add({1, {2e-3, 1e-3}, -1e-6, false, true, {}}, slider);
  EXPECT_EQ(solution.worst_complementarity_residual, 1);
}

/// The motion of the small case as waypoints, each leg in so many rows.
Case in_rows(int rows) {
  Case input = small_case();
  input.motion.kind = MotionKind::waypoints;
  input.motion.waypoints = {{0, {1.5e-3, 1e-3}, 1e-3, {}}, {0.5, {1.5e-3, 1e-3}, -1e-6, {}}};
  for (int i = 1; i <= rows; ++i) {
    const double part = static_cast<double>(i) / rows;
    input.motion.waypoints.push_back({0.5 + 2 * part, {1.5e-3 + 2e-3 * part, 1e-3}, -1e-6, {}});
  }
  input.motion.waypoints.push_back({3, {3.5e-3, 1e-3}, 1e-3, {}});
  return input;
}

TEST(SteppedMotion, is_the_same_in_any_number_of_rows) {
  base::Timers timers;
  ContactOptions options;
  options.threads = 2;
  const Case input = small_case();
  const ContactSolution stroke = solve_contact(input, options, timers);
  const ContactState& landed = *nearest(stroke, 0.5).state;
  const ContactState end =
      solve_steady_sliding(input, {input.motion.stroke}, options, timers).front();
  for (const int rows : {1, 500}) {
    const ContactSolution stepped = solve_contact(in_rows(rows), options, timers);
    EXPECT_LT(stepped.stepped.size(), 200u);
    EXPECT_LT(stepped.worst_complementarity_residual, 1e-6);
    const SteppedInstant &pressed = nearest(stepped, 0.5), &slid = nearest(stepped, 2.5);
    EXPECT_EQ(pressed.time, 0.5);
    EXPECT_NEAR(pressed.state->normal_force, landed.normal_force, 1e-6 * landed.normal_force);
    EXPECT_EQ(slid.time, 2.5);
    EXPECT_NEAR(slid.state->normal_force, end.normal_force, 1e-5 * end.normal_force);
    EXPECT_LT(difference(core_strain(*slid.state).component[4], end.strain.component[4]), 1e-4);
    EXPECT_EQ(stepped.stepped_events.size(), 4u); // lands, slides, lifts, leaves
    EXPECT_EQ(stepped.stepped_onsets.size(), 1u);
    EXPECT_EQ(stepped.stepped.back().state, nullptr);
    EXPECT_NEAR(stepped.stepped_events.back(), 2.5 + 0.5 / 1001, 1e-12);
  }
}

TEST(SteppedMotion, touches_with_the_same_shared_positions_solve_the_skin_once) {
  Case one = small_case();
  one.slider.shape = "sphere";
  one.slider.parameters["radius"] = 8e-3;
  one.motion.preload = 0;
  one.motion.preload_force = 0.2;
  one.motion.stroke = 1e-3;
  Case other = one;
  other.slider.start = {1.7e-3, 1.05e-3};
  other.motion.preload_force = 0.1;
  other.contact.friction = 0.5;
  const mesh::Footprint largest = find_footprint(one, 0.5, 2);
  for (Case* input : {&one, &other}) {
    input->numerics.shared = {{1.4e-3, 0.95e-3}, {2.9e-3, 1.05e-3}, largest.half_size};
  }
  std::string name = (std::filesystem::temp_directory_path() / "ionskin-shared-XXXXXX").string();
  ASSERT_NE(mkdtemp(name.data()), nullptr);
  base::DiskCache cache(name, 500'000'000);
  base::Timers timers;
  ContactOptions options;
  options.threads = 2;
  options.cache = &cache;
  solve_contact(one, options, timers);
  const std::size_t kept = cache.content().entries;
  EXPECT_GT(kept, 4u);
  const ContactSolution shared = solve_contact(other, options, timers);
  EXPECT_EQ(cache.content().entries, kept);
  std::filesystem::remove_all(name);

  other.numerics.shared = {};
  options.cache = nullptr;
  const ContactSolution alone = solve_contact(other, options, timers);
  const ContactState &landed = *nearest(shared, 0.5).state, &expected = *nearest(alone, 0.5).state;
  EXPECT_NEAR(landed.normal_force, 0.1, 1e-9);
  // Meshes differ: that of the own footprint is finer.
  EXPECT_NEAR(landed.indentation, expected.indentation, 0.05 * expected.indentation);
}

TEST(SteppedMotion, lands_and_leaves_by_force_on_the_way) {
  Case input = small_case();
  input.motion.kind = MotionKind::waypoints;
  input.motion.waypoints = {{0, {1.5e-3, 1e-3}, 1e-6, {}},
                            {1, {2.0e-3, 1e-3}, {}, 5.0},
                            {2, {3.0e-3, 1e-3}, {}, 8.0},
                            {3, {3.5e-3, 1e-3}, 1e-6, {}}};
  base::Timers timers;
  ContactOptions options;
  options.nodes = 3;
  const ContactSolution solution = solve_contact(input, options, timers);
  EXPECT_NEAR(nearest(solution, 1).state->normal_force, 5, 1e-6);
  EXPECT_NEAR(nearest(solution, 2).state->normal_force, 8, 1e-6);
  EXPECT_NEAR(nearest(solution, 2).height, -nearest(solution, 2).state->indentation, 1e-12);
  EXPECT_GT(solution.stepped_events.front(), 0);
  EXPECT_LT(solution.stepped_events.front(), 1);
  EXPECT_EQ(solution.stepped.back().state, nullptr);
}

TEST(SteppedMotion, round_sliders_land_while_they_move) {
  for (const char* shape : {"sphere", "cylinder"}) {
    Case input = small_case();
    input.slider.shape = shape;
    input.slider.parameters["radius"] = 8e-3;
    input.motion.kind = MotionKind::waypoints;
    input.motion.waypoints = {{0, {1.5e-3, 1e-3}, 1e-6, {}},
                              {1, {2.5e-3, 1e-3}, -1e-6, {}},
                              {2, {3.0e-3, 1e-3}, 1e-6, {}}};
    base::Timers timers;
    ContactOptions options;
    options.nodes = 3;
    const ContactSolution solution = solve_contact(input, options, timers);
    EXPECT_LT(solution.worst_complementarity_residual, 1e-6) << shape;
    ASSERT_EQ(solution.stepped_events.size(), 2u) << shape; // lands and leaves
    EXPECT_NEAR(solution.stepped_events.front(), 0.5, 0.01) << shape;
    EXPECT_NEAR(solution.stepped_events.back(), 1.5, 0.01) << shape;
    // All of it slips as soon as it touches.
    const ContactState& pressed = *nearest(solution, 1).state;
    EXPECT_GT(pressed.normal_force, 0) << shape;
    EXPECT_NEAR(pressed.tangential_force[0], input.contact.friction * pressed.normal_force,
                1e-6 * pressed.normal_force)
        << shape;
  }
}

TEST(SteppedMotion, rubs_by_a_fifth_of_a_micrometre_in_closed_loops) {
  Case input = small_case();
  input.motion.kind = MotionKind::waypoints;
  input.motion.waypoints = {{0, {2e-3, 1e-3}, 1e-6, {}}, {0.1, {2e-3, 1e-3}, -1e-6, {}}};
  for (int i = 1; i <= 120; ++i) {
    input.motion.waypoints.push_back(
        {0.1 + 0.01 * i, {2e-3 + 0.2e-6 * std::sin(2 * M_PI * i / 40), 1e-3}, -1e-6, {}});
  }
  input.output.fields = {0.6, 0.8, 1.0}; // are passed
  base::Timers timers;
  ContactOptions options;
  options.threads = 2;
  const ContactSolution solution = solve_contact(input, options, timers);
  // After the first rise every turn is as the one before.
  const auto force = [&](double time) {
    return nearest(solution, time).state->tangential_force[0];
  };
  EXPECT_NEAR(force(0.6), force(1.0), 1e-3 * std::abs(force(0.6)));
  EXPECT_NEAR(force(0.8), -force(1.0), 0.1 * std::abs(force(0.6)));
  EXPECT_GT(nearest(solution, 0.6).state->stick_fraction, 0);
}

TEST(SteppedMotion, takes_strokes_under_laws_of_speed_and_rests) {
  Case input = small_case();
  input.motion.kind = MotionKind::reciprocating;
  input.motion.strokes = 2;
  input.motion.dwell = 1;
  input.contact.law = "viscous";
  input.contact.parameters = {{"reference_speed", 1e-3}};
  base::Timers timers;
  ContactOptions options;
  options.nodes = 3;
  const ContactSolution solution = solve_contact(input, options, timers);
  const auto ratio = [&](double time) {
    const ContactState& state = *nearest(solution, time).state;
    return state.tangential_force[0] / state.normal_force;
  };
  EXPECT_NEAR(ratio(1.5), 0.3, 1e-3); // 1 mm/s
  EXPECT_NEAR(ratio(3.5), 0.0, 1e-3); // relaxed in the rest
  EXPECT_NEAR(ratio(4.5), -0.3, 1e-3);
  EXPECT_EQ(nearest(solution, 1.5).state->stick_fraction, 0);
}

} // namespace
} // namespace ionskin::mechanics
