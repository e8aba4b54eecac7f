// SPDX-License-Identifier: Apache-2.0
#include "ionskin/base/error.hpp"
#include "ionskin/handover/contact_timeline.hpp"
#include "ionskin/handover/energy_balance.hpp"
#include "ionskin/handover/handover.hpp"
#include "ionskin/mechanics/solve_contact.hpp"
#include "mechanics/baseline_case.hpp"
#include "mechanics/rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace ionskin::verification {
namespace {

using mechanics::ContactSolution;

ContactSolution solve_path(const Case& input, const Options& options) {
  mechanics::ContactOptions contact;
  contact.threads = options.threads;
  base::Timers timers;
  return mechanics::solve_contact(input, contact, timers);
}

/// Case with the stroke of another case as the rows of a path.
Case in_rows(Case input, int rows) {
  const Motion strokes = input.motion;
  input.motion.kind = MotionKind::waypoints;
  const auto place = [&](double part) {
    return std::array{input.slider.start[0] + part * strokes.stroke, input.slider.start[1]};
  };
  auto& path = input.motion.waypoints;
  path = {{0, place(0), strokes.gap, {}}, {strokes.touchdown, place(0), -strokes.preload, {}}};
  for (int i = 1; i <= rows; ++i) {
    const double part = static_cast<double>(i) / rows;
    path.push_back({strokes.touchdown + part * strokes.slide, place(part), -strokes.preload, {}});
  }
  path.push_back({strokes.touchdown + strokes.slide + strokes.lift, place(1), strokes.gap, {}});
  return input;
}

/// Adds rows that compare a slide, in its middle and over its onset, from the legs of a stroke and
/// from rows of a path.
void add_leg_rows(const Options& options, std::vector<Row>& rows) {
  const Case stroke = baseline_case(), path = in_rows(stroke, 500);
  const ContactSolution legs = solve_path(stroke, options), stepped = solve_path(path, options);
  const handover::ContactTimeline leg_time(stroke, legs), step_time(path, stepped);
  const double middle = stroke.motion.touchdown + 0.5 * stroke.motion.slide;
  const auto shear = [](const Case& input, const ContactSolution& solution,
                        const handover::ContactTimeline& timeline, double time) {
    return handover::mechanics_shear_integral(input, solution.mesh, timeline.at(time));
  };
  const auto of_legs = leg_time.at(middle), of_rows = step_time.at(middle);
  rows.push_back(at_most("M12", "path of 500 rows against the stroke: normal force, relative",
                         std::abs(of_rows.normal_force() / of_legs.normal_force() - 1), 1e-5));
  rows.push_back(at_most(
      "M12", "path of 500 rows against the stroke: mean shear, relative",
      std::abs(shear(path, stepped, step_time, middle) / shear(stroke, legs, leg_time, middle) - 1),
      1e-4));
  double onset = 0;
  for (const double time : leg_time.sample_times()) {
    if (time >= stroke.motion.touchdown && time <= stroke.motion.touchdown + stroke.motion.slide) {
      onset = std::max(onset, std::abs(step_time.at(time).tangential_force()[0] -
                                       leg_time.at(time).tangential_force()[0]));
    }
  }
  rows.push_back(at_most(
      "M12", "path of 500 rows against the stroke: tangential force with its onset, relative",
      onset / std::abs(of_legs.tangential_force()[0]), 0.02));
  rows.push_back(at_most("M12", "energy balance of the path, relative",
                         handover::energy_balance(step_time, stepped).relative_error, 5e-3));
}

/// Case of a random path: steps from a tenth of a micrometre to the whole stroke, which press,
/// slide, turn, land and lift off at random.
Case random_path(Case input, bool by_force, unsigned seed) {
  std::mt19937 random(seed);
  const auto unit = [&] { return static_cast<double>(random()) / 4294967296.0; };
  input.motion.kind = MotionKind::waypoints;
  auto& path = input.motion.waypoints;
  path = {{0, {2.5e-3, 1e-3}, 1e-6, {}}};
  double x = 2.5e-3;
  for (int i = 1; i <= 120; ++i) {
    const double size = 2e-3 * std::pow(10, -4.3 * unit());
    x = std::clamp(x + (unit() < 0.5 ? -size : size), 1.5e-3, 3.5e-3);
    const bool leaves = unit() < 0.05;
    Waypoint next{0.01 * i, {x, 1e-3}, {}, {}};
    if (leaves || !by_force) {
      next.height = leaves ? 1e-6 * unit() : -1e-6 * (0.1 + 0.9 * unit());
    } else {
      next.force = 0.2 + 3 * unit();
    }
    path.push_back(next);
  }
  return input;
}

Case with_shape(const std::string& shape, double edge_radius) {
  Case input = baseline_case();
  input.skin.length = 5e-3;
  input.slider.size = {1e-3, 0.8e-3};
  input.slider.start = {2.5e-3, 1e-3};
  input.slider.shape = shape;
  input.slider.parameters["edge_radius"] = edge_radius;
  input.numerics.mesh_refinement = 0.5;
  if (shape != "flat") {
    input.slider.parameters["radius"] = 8e-3;
  }
  return input;
}

void add_random_rows(const Options& options, std::vector<Row>& rows) {
  struct Shape {
    const char* name;
    Case input;
  };
  const Shape shapes[] = {{"flat", with_shape("flat", 0)},
                          {"rounded", with_shape("flat", 0.1e-3)},
                          {"cylinder", with_shape("cylinder", 0)},
                          {"sphere", with_shape("sphere", 0)}};
  int steps = 0, failures = 0;
  unsigned seed = 0;
  for (const Shape& shape : shapes) {
    double worst = 0;
    for (const bool by_force : {false, true}) {
      try {
        const ContactSolution solution =
            solve_path(random_path(shape.input, by_force, ++seed), options);
        steps += solution.contact_solves;
        worst = std::max(worst, solution.worst_complementarity_residual);
      } catch (const SolverError&) {
        ++failures;
        worst = std::numeric_limits<double>::infinity();
      }
    }
    rows.push_back(at_most("M12",
                           fmt::format("random paths, {} slider, by height and by force: worst "
                                       "violation of contact and friction, relative",
                                       shape.name),
                           worst, 1e-6));
  }
  rows.push_back(at_most("M12", fmt::format("random paths without a solution, of {} steps", steps),
                         failures, 0));
}

} // namespace

std::vector<Row> path_rows(const Options& options) {
  std::vector<Row> rows;
  options.progress("mechanics: paths", 0);
  add_leg_rows(options, rows);
  options.progress("mechanics: paths", 0.4);
  add_random_rows(options, rows);
  options.progress("mechanics: paths", 1);
  return rows;
}

} // namespace ionskin::verification
