// SPDX-License-Identifier: Apache-2.0
#include "ionskin/case/slider_motion.hpp"
#include "ionskin/mechanics/solve_contact.hpp"
#include "ionskin/parallel/task_pool.hpp"
#include "mechanics/rows.hpp"

#include <array>
#include <cmath>
#include <functional>
#include <numbers>

namespace ionskin::verification {
namespace {
namespace rolling {

constexpr double friction = 0.3, radius = 10e-3, modulus = 1e9, width = 1e-3;
constexpr double poissons_ratio = 0.4999; // pressure moves nothing sideways
constexpr double half_contact = 0.02 * radius, steepest = 0.085;

double plane_modulus() {
  return modulus / (1 - poissons_ratio * poissons_ratio);
}

/// Case of a cylinder that lands tilted on a deep block in plane strain, and rolls over the point
/// about which it is tilted. Creep is the travel of this point over the travel of the contact.
Case rolling_cylinder(double creep, double depth_ratio) {
  const double depth = depth_ratio * half_contact;
  constexpr int legs = 120;
  const Material material{"block", modulus, poissons_ratio};
  Case input;
  input.skin.length = 4 * depth;
  input.skin.width = width;
  input.skin.sides = SideCondition::symmetry;
  input.skin.layers = {{"lower", LayerRole::electrode, material, 0.3 * depth},
                       {"middle", LayerRole::core, material, 0.4 * depth},
                       {"upper", LayerRole::electrode, material, 0.3 * depth}};
  input.slider.shape = "cylinder";
  input.slider.parameters["radius"] = radius;
  input.slider.size = {2 * radius, 2 * radius};
  input.slider.start = {input.skin.length / 2, width / 2};
  input.contact.friction = friction;
  input.numerics.preset = Preset::coarse;
  input.numerics.mesh_refinement = 4;
  input.motion.kind = MotionKind::waypoints;
  input.motion.cycles = 1;
  const double force =
      width * std::numbers::pi * plane_modulus() * half_contact * half_contact / (4 * radius);
  input.motion.waypoints = {{0, input.slider.start, 1e-6, {}}};
  for (int leg = 0; leg <= legs; ++leg) {
    const double pitch = steepest * (2.0 * leg / legs - 1);
    const double way = radius * (std::tan(pitch) + std::tan(steepest));
    input.motion.waypoints.push_back(
        {0.1 + 0.01 * leg, {input.slider.start[0] + creep * way, width / 2}, std::nullopt, force});
    input.motion.waypoints.back().pitch = pitch;
  }
  input.motion.waypoints.front().pitch = -steepest;
  settle_pose(input);
  return input;
}

/// State at the end of the travel: force along it over the force of full slip, length of the stick
/// zone over the contact's, and position of the pressure's centre relative to where the tilt places
/// it.
struct Rolled {
  double force = 0, stick = 0, middle = 0;
};

Rolled rolled(double creep, double depth_ratio) {
  const Case input = rolling_cylinder(creep, depth_ratio);
  base::Timers timers;
  mechanics::ContactOptions options;
  const mechanics::ContactSolution solution = mechanics::solve_contact(input, options, timers);
  const mechanics::ContactState& end = *solution.stepped.back().state;
  return {end.tangential_force[0] / (friction * end.normal_force),
          end.stick_area / end.contact_area,
          end.moment[1] / (end.normal_force * radius * std::sin(steepest))};
}

/// Extrapolates a value to infinite depth from blocks of which the second is twice as deep. The
/// surface of a block of finite depth strains under the force, which acts as a creep and falls like
/// the contact over the depth.
double at_infinite_depth(double shallow, double deep) {
  return 2 * deep - shallow;
}

} // namespace rolling
} // namespace

std::vector<Row> rolling_rows(const Options& options) {
  // With the creep a share s of that of full slip the contact sticks over 1 - s of its length, from
  // its front on, and the force is 1 - (1 - s)^2 of that of full slip (Carter 1926, doi
  // 10.1098/rspa.1926.0100; Johnson, Contact Mechanics, 1985, section 8.3).
  constexpr double full = rolling::friction * rolling::half_contact / rolling::radius;
  std::array<rolling::Rolled, 2> free, half; // shallow, deep
  rolling::Rolled slipping;
  const std::array<std::function<void()>, 5> solves{
      [&] { half[1] = rolling::rolled(0.5 * full, 16); },
      [&] { slipping = rolling::rolled(2 * full, 16); },
      [&] { half[0] = rolling::rolled(0.5 * full, 8); }, [&] { free[1] = rolling::rolled(0, 16); },
      [&] { free[0] = rolling::rolled(0, 8); }};
  parallel::run_tasks(solves.size(), options.threads, [&](std::size_t i) { solves[i](); });
  std::vector<Row> rows;
  rows.push_back(compare("M19", "rolling cylinder without creep: force over that of full slip",
                         rolling::at_infinite_depth(free[0].force, free[1].force), 0, 0.01));
  rows.push_back(compare("M19", "the same: arm of the pressure over radius times sine of the pitch",
                         free[1].middle, 1, 0.01));
  rows.push_back(compare("M19", "half of the creep of full slip: force over that of full slip",
                         rolling::at_infinite_depth(half[0].force, half[1].force), 0.75, 0.03));
  rows.push_back(compare("M19", "the same: length of the stick over that of the contact",
                         rolling::at_infinite_depth(half[0].stick, half[1].stick), 0.5, 0.03));
  rows.push_back(compare("M19", "twice the creep of full slip: force over that of full slip",
                         slipping.force, 1, 1e-4));
  return rows;
}

} // namespace ionskin::verification
