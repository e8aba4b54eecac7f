// SPDX-License-Identifier: Apache-2.0
#include "ionskin/base/error.hpp"
#include "ionskin/mechanics/engine/sliding_contact.hpp"
#include "ionskin/mechanics/surface/contact_diagnostics.hpp"
#include "largest_difference.hpp"
#include "small_line.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace ionskin::mechanics {
namespace {

TEST(SlidingContact, IsTheContactOfSingleSteps) {
  SlidingContact slider = line().slider();
  slider.step(0.1, {2e-3, 1e-3}, {LoadKind::indentation, 1e-6});
  EXPECT_TRUE(slider.sticks());
  double before = 0;
  for (const double travel : {0.1e-6, 0.4e-6, 1e-6, 4e-6, 3.8e-6, 2e-6}) {
    const SurfaceState start = slider.state();
    slider.step(0.01, {2e-3 + travel, 1e-3}, {LoadKind::indentation, 1e-6});
    const SliderStep step{{LoadKind::indentation, 1e-6}, {travel - before, 0}, 0.01, start.surface};
    const SurfaceState direct = solve_contact_step(slider.problem(), step, start.force);
    EXPECT_LT(largest_difference(slider.state().force, direct.force), 1e-7) << travel;
    before = travel;
  }
  EXPECT_EQ(slider.fallbacks(), 0);
}

TEST(SlidingContact, HoldsAForceAndLeavesWithoutATrace) {
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

double tangential_force(const SurfaceState& state) {
  double sum = 0;
  for (std::size_t at = 0; at < state.force.size(); at += 3) {
    sum += state.force[at + 1];
  }
  return sum;
}

TEST(SlidingContact, TakesAnyStepOfARandomWalk) {
  for (const laws::Friction& law : all_laws()) {
    for (const bool by_force : {false, true}) {
      SlidingContact slider = line().slider(law);
      std::mt19937 random(by_force ? 2 : 1);
      std::uniform_real_distribution<double> unit(-1, 1);
      double x = 2.5e-3, worst = 0, work = 0;
      for (int i = 0; i < 100; ++i) {
        const double size = std::pow(10, -3 - 3 * std::abs(unit(random))); // 1 um to 1 mm
        const double from = x;
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
          work += std::abs(tangential_force(state) * (x - from));
          worst =
              std::max(worst, contact_violations(slider.problem(), state, largest, 1e-6).largest());
        }
      }
      EXPECT_LT(worst, 1e-5) << law.law;
      EXPECT_LT(slider.created_energy(), 1e-9 * work) << law.law;
    }
  }
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

TEST(SlidingContact, SlidesWithTheCoefficientOfItsSpeed) {
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

TEST(SlidingContact, FrictionThatLagsConvergesWithTheStep) {
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

TEST(SlidingContact, ElasticSlipComesBackInAnyNumberOfSteps) {
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

/// Work of a slider along the skin, over the sum of its magnitudes, that is moved a way and back
/// again and again, under one force there and another one back.
double work_of_cycles(const laws::Friction& law, double force_there, double force_back) {
  SlidingContact slider = line().slider(law);
  constexpr int steps = 40, cycles = 3;
  double work = 0, all = 0;
  const auto go = [&](double from, double to, double first, double last) {
    for (int i = 1; i <= steps; ++i) {
      const double part = static_cast<double>(i) / steps, before = tangential_force(slider.state());
      slider.step(1e-3, {2e-3 + from + part * (to - from), 1e-3},
                  {LoadKind::force, first + part * (last - first)});
      const double done = 0.5 * (before + tangential_force(slider.state())) * (to - from) / steps;
      work += done;
      all += std::abs(done);
    }
  };
  constexpr double way = 20e-6;
  go(0, 0, 0, force_there);
  for (int i = 0; i < cycles; ++i) {
    go(0, way, force_there, force_there);
    go(way, way, force_there, force_back);
    go(way, 0, force_back, force_back);
    go(0, 0, force_back, force_there);
  }
  EXPECT_LT(slider.created_energy(), 1e-9 * all);
  return work / all;
}

TEST(SlidingContact, NoCycleOfForceAndWayGivesEnergy) {
  const auto law = laws::friction("regularised", 0.5, {{"slip_length", 100e-6}});
  EXPECT_GT(work_of_cycles(law, 1, 20), 0);
  EXPECT_GT(work_of_cycles(law, 20, 1), 0);
  EXPECT_NEAR(work_of_cycles(law, 5, 5), 0, 0.01); // elastic
}

TEST(SlidingContact, AStepWithoutSolutionLeavesWhatFrictionRemembers) {
  SlidingContact slider = line().slider(laws::friction(
      "stribeck", 0.3, {{"kinetic_friction", 0.2}, {"stribeck_speed", 1e-3}, {"lag_time", 5e-3}}));
  slider.step(0.1, {2e-3, 1e-3}, {LoadKind::indentation, 1e-6});
  slider.step(0.01, {2.05e-3, 1e-3}, {LoadKind::indentation, 1e-6});
  const std::vector<double> before = slider.problem().lagged_speed;
  constexpr double no_number = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(slider.step(0.01, {2.1e-3, 1e-3}, {LoadKind::indentation, no_number}), SolverError);
  EXPECT_EQ(slider.problem().lagged_speed, before);
}

} // namespace
} // namespace ionskin::mechanics
