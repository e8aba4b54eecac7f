// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/solve_contact.hpp"
#include "mechanics/baseline_case.hpp"
#include "mechanics/rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

namespace ionskin::verification {
namespace {

using Ratio = std::array<double, 2>;

constexpr double coefficient = 0.3;
constexpr double stroke_length = 0.5e-3; // [m]

/// Case of a short stroke of a small flat slider, on a skin so wide that the stroke may go in any
/// direction.
Case short_stroke(const std::string& law, const laws::LawValues& parameters, double speed,
                  const std::array<double, 2>& direction) {
  Case input = baseline_case();
  input.skin.length = 4e-3;
  input.slider.size = {1e-3, 0.8e-3};
  input.slider.start = {1.75e-3, 1e-3};
  input.motion.direction = direction;
  input.motion.stroke = stroke_length;
  input.motion.slide = stroke_length / speed;
  input.numerics.mesh_refinement = 0.5;
  input.contact.law = law;
  input.contact.friction = coefficient;
  input.contact.parameters = parameters;
  return input;
}

mechanics::ContactSolution solve_at_one_place(const Case& input, const Options& options) {
  mechanics::ContactOptions contact;
  contact.threads = options.threads;
  base::Timers timers;
  return mechanics::solve_contact(input, contact, timers);
}

const mechanics::ContactState& at(const mechanics::ContactSolution& solution, double time) {
  return *std::ranges::min_element(solution.stepped, {}, [&](const auto& instant) {
            return std::abs(instant.time - time);
          })->state;
}

/// Ratio of the tangential to the normal force, along x and y, in the middle of the stroke.
Ratio sliding_ratio(const Case& input, const Options& options) {
  const mechanics::ContactSolution solution = solve_at_one_place(input, options);
  const mechanics::ContactState& state =
      at(solution, input.motion.touchdown + input.motion.slide / 2);
  return {state.tangential_force[0] / state.normal_force,
          state.tangential_force[1] / state.normal_force};
}

void add_speed_rows(const Options& options, std::vector<Row>& rows) {
  const laws::LawValues viscous{{"reference_speed", 1e-3}};
  for (const double speed : {1e-3, 0.25e-3}) {
    rows.push_back(
        compare("M13", fmt::format("viscous friction at {} mm/s: T / N", speed * 1e3),
                sliding_ratio(short_stroke("viscous", viscous, speed, {1, 0}), options)[0],
                coefficient * speed / 1e-3, 1e-3 * coefficient));
  }
  const laws::LawValues stribeck{
      {"kinetic_friction", 0.2}, {"stribeck_speed", 1e-3}, {"lag_time", 5e-3}};
  rows.push_back(
      compare("M13", "Stribeck friction at the Stribeck speed: T / N",
              sliding_ratio(short_stroke("stribeck", stribeck, 1e-3, {1, 0}), options)[0],
              0.2 + 0.1 * std::exp(-1.0), 1e-3 * coefficient));
}

void add_direction_rows(const Options& options, std::vector<Row>& rows) {
  constexpr double across = 0.1;
  const laws::LawValues grain{{"transverse_friction", across}};
  const auto ratio = [&](const std::array<double, 2>& direction) {
    return sliding_ratio(short_stroke("anisotropic", grain, 1e-3, direction), options);
  };
  rows.push_back(
      compare("M13", "anisotropic friction along x: T / N", ratio({1, 0})[0], coefficient, 1e-5));
  rows.push_back(
      compare("M13", "anisotropic friction along y: T / N", ratio({0, 1})[1], across, 1e-5));
  const double half = std::sqrt(0.5);
  const Ratio oblique = ratio({half, half});
  rows.push_back(compare("M13", "anisotropic friction at 45 degrees: T_y / T_x",
                         oblique[1] / oblique[0], across * across / (coefficient * coefficient),
                         1e-3));
}

/// Loop of a slider that is pressed, moved by a travel, and moved back: tangential forces over that
/// of full slip.
struct Loop {
  double half_way = 0, turn = 0;
  double back = 0; ///< place where it began
};

Loop loop_of(const std::string& law, const laws::LawValues& parameters, double travel,
             const Options& options) {
  Case input = short_stroke(law, parameters, 1e-3, {1, 0});
  input.slider.shape = "sphere";
  input.slider.parameters["radius"] = 8e-3;
  // A deep block on which pressure moves nothing sideways.
  const Material soft{"soft", 249e6, 0.4999};
  constexpr double depth_of_block = 0.75e-3;
  input.skin.length = input.skin.width = 4 * depth_of_block;
  input.slider.start = {2 * depth_of_block, 2 * depth_of_block};
  for (Layer& layer : input.skin.layers) {
    layer.material = soft;
    layer.thickness = depth_of_block / 3;
  }
  input.motion.kind = MotionKind::waypoints;
  const double depth = 2e-6;
  const auto row = [&](double time, double way, double height) {
    return Waypoint{
        time, {input.slider.start[0] + way * travel, input.slider.start[1]}, height, {}};
  };
  input.motion.waypoints = {row(0, 0, 1e-6), row(0.1, 0, -depth)};
  for (int i = 1; i <= 20; ++i) {
    input.motion.waypoints.push_back(row(0.1 + 0.01 * i, 0.05 * i, -depth));
  }
  for (int i = 1; i <= 20; ++i) {
    input.motion.waypoints.push_back(row(0.3 + 0.01 * i, 1 - 0.05 * i, -depth));
  }
  input.output.fields = {0.1, 0.2, 0.3}; // are passed
  const mechanics::ContactSolution solution = solve_at_one_place(input, options);
  const auto force = [&](double time) {
    const mechanics::ContactState& state = at(solution, time);
    return (state.tangential_force[0] - at(solution, 0.1).tangential_force[0]) /
           (coefficient * state.normal_force);
  };
  return {force(0.2), force(0.3), force(0.5)};
}

/// Adds rows on loops: the branch after a reversal is the first branch, turned and twice as large
/// (Masing 1926), which is the loop of Mindlin and Deresiewicz 1953 for spheres and holds for every
/// law that does not depend on speed.
void add_loop_rows(const Options& options, std::vector<Row>& rows) {
  constexpr double travel = 1e-6;
  const Loop coulomb = loop_of("coulomb", {}, travel, options);
  const std::array<std::pair<std::string, Loop>, 4> loops{
      {{"coulomb", coulomb},
       {"saturating",
        loop_of("saturating", {{"strength", 1e6}, {"sharpness", 2}}, travel, options)},
       {"regularised", loop_of("regularised", {{"slip_length", 0.2e-6}}, travel, options)},
       {"anisotropic", loop_of("anisotropic", {{"transverse_friction", 0.1}}, travel, options)}}};
  for (const auto& [law, loop] : loops) {
    rows.push_back(compare(
        "M13",
        fmt::format("sphere, {} friction: loop against Mindlin and Deresiewicz, over mu N", law),
        loop.back, loop.turn - 2 * loop.half_way, 0.01));
  }
  const Loop sharp = loop_of("regularised", {{"slip_length", 1e-8}}, travel, options);
  rows.push_back(compare("M13",
                         "sphere, elastic slip of 10 nm: partial slip against Coulomb's, over mu N",
                         sharp.half_way, coulomb.half_way, 0.02));
}

} // namespace

std::vector<Row> friction_rows(const Options& options) {
  std::vector<Row> rows;
  options.progress("mechanics: friction laws", 0);
  add_speed_rows(options, rows);
  options.progress("mechanics: friction laws", 0.4);
  add_direction_rows(options, rows);
  options.progress("mechanics: friction laws", 0.7);
  add_loop_rows(options, rows);
  options.progress("mechanics: friction laws", 1);
  return rows;
}

} // namespace ionskin::verification
