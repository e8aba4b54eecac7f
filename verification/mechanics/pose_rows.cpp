// SPDX-License-Identifier: Apache-2.0
#include "ionskin/case/slider_motion.hpp"
#include "ionskin/mechanics/solve_contact.hpp"
#include "ionskin/parallel/task_pool.hpp"
#include "mechanics/baseline_case.hpp"
#include "mechanics/pressed_skin.hpp"
#include "mechanics/rows.hpp"

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_2.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>

namespace ionskin::verification {
namespace {

using std::numbers::pi;

constexpr double modulus_of_block = 1e9; // [Pa]

/// Case of a block of one material, four times as long as deep.
Case even_block(double depth, double poissons_ratio) {
  const Material material{"block", modulus_of_block, poissons_ratio};
  Case input;
  input.skin.length = input.skin.width = 4 * depth;
  input.skin.layers = {{"lower", LayerRole::electrode, material, 0.3 * depth},
                       {"middle", LayerRole::core, material, 0.4 * depth},
                       {"upper", LayerRole::electrode, material, 0.3 * depth}};
  input.slider.start = {2 * depth, 2 * depth};
  input.numerics.preset = Preset::coarse;
  return input;
}

/// Moment over that of a tilted flat punch without friction on a half-space in plane strain, whose
/// pressure is odd in x beside that of the force, p = E* theta x / (2 sqrt(a^2 - x^2)): per width
/// pi a^2 E* theta / 4 (Muskhelishvili 1953; Johnson, Contact Mechanics, 1985, section 2.8).
double tilted_punch(double depth_ratio, double refinement) {
  constexpr double half_width = 1e-3, tilt = 1e-4, nu = 0.3;
  Case input = even_block(depth_ratio * half_width, nu);
  input.skin.sides = SideCondition::symmetry;
  input.skin.width = 1e-3;
  input.slider.start[1] = input.skin.width / 2;
  input.slider.size = {2 * half_width, 2 * input.skin.width};
  input.slider.pose.pitch = tilt;
  input.motion.preload = 12 * half_width * tilt; // all of it stays in contact
  input.numerics.mesh_refinement = refinement;
  PressedSkin skin(input);
  skin.advance({0, 0});
  const double expected =
      pi * half_width * half_width * modulus_of_block / (1 - nu * nu) * tilt / 4;
  return skin.moment()[1] / input.skin.width / expected;
}

/// Difference of the complete elliptic integrals K(k) - E(k) with k^2 = 1 - x^2.
double difference_of_integrals(double x) {
  const double k = std::sqrt((1 - x) * (1 + x));
  return boost::math::ellint_1(k) - boost::math::ellint_2(k);
}

/// A sphere that is pressed by a force P and then turned, while it sticks within the radius c of
/// the contact radius a (Lubkin 1951, doi 10.1115/1.4010277). Rings of rigid turns, each of a disc
/// that sticks (Reissner and Sagoci 1944), make the traction mu p where it slips, which gives
/// beta = 3 mu P / (4 pi G a^2) (K - E) of the half-space, and the torque below.
struct Lubkin {
  double turn = 0;   ///< beta G a^2 / (mu P)
  double torque = 0; ///< torque over mu P a
};

Lubkin lubkin(double stick_radius) { // over a
  const double c = stick_radius;
  const double behind = boost::math::quadrature::gauss_kronrod<double, 61>::integrate(
      [](double s) { return s * s * difference_of_integrals(s); }, c, 1.0);
  return {3 / (4 * pi) * difference_of_integrals(c),
          4 / pi * (c * c * c * difference_of_integrals(c) + 3 * behind)};
}

/// Torque of Lubkin's sphere after a given turn, over mu P a.
double lubkin_torque(double turn) {
  std::uintmax_t iterations = 100;
  const auto [low, high] = boost::math::tools::toms748_solve(
      [&](double c) { return lubkin(c).turn - turn; }, 1e-6, 1 - 1e-12,
      [](double a, double b) { return b - a < 1e-13; }, iterations);
  return lubkin((low + high) / 2).torque;
}

/// Torques of a spinning sphere over mu P a: where about half of the radius sticks, over Lubkin's,
/// and in full slip, over 3 pi / 16.
struct SphereSpin {
  double partial = 0, full = 0;
};

/// Torques of a spinning sphere on a nearly incompressible block, in which pressure moves nothing
/// sideways.
SphereSpin sphere_spin(double refinement) {
  constexpr double radius = 10e-3, indentation = 10e-6, nu = 0.4999, mu = 0.3;
  const double contact = std::sqrt(radius * indentation);
  Case input = even_block(6 * contact, nu);
  input.slider.shape = "sphere";
  input.slider.parameters["radius"] = radius;
  input.slider.size = {2 * radius, 2 * radius};
  input.slider.changing.yaw = true; // all of it is meshed
  input.motion.preload = indentation;
  input.contact.friction = mu;
  input.numerics.mesh_refinement = refinement;
  PressedSkin skin(input);
  skin.advance({0, 0});
  const double force = skin.force(0), shear_modulus = modulus_of_block / (2 * (1 + nu));
  const double a = std::cbrt(0.75 * force * radius * (1 - nu * nu) / modulus_of_block);
  const double turn = lubkin(0.5).turn;
  constexpr int steps = 3;
  for (int i = 0; i < steps; ++i) {
    skin.advance({0, 0}, turn * mu * force / (shear_modulus * a * a) / steps);
  }
  SphereSpin result;
  const double scale = mu * force * a;
  result.partial = skin.moment()[2] / scale / lubkin_torque(turn);
  skin.advance({0, 0}, 100 * turn * mu * force / (shear_modulus * a * a));
  result.full = skin.moment()[2] / scale / (3 * pi / 16);
  return result;
}

/// Largest relative deviation of moment over force from the arm radius times tan(tilt), for a
/// sphere that is tilted about its lowest point and so touches beside this point.
double tilted_sphere() {
  constexpr double radius = 4e-3, tilt = 0.02;
  Case input = even_block(2e-3, 0.3);
  input.slider.shape = "sphere";
  input.slider.parameters["radius"] = radius;
  input.slider.size = {2 * radius, 2 * radius};
  input.slider.pose = {tilt, tilt, 0};
  input.motion.preload = 10e-6;
  PressedSkin skin(input);
  skin.advance({0, 0});
  const double arm = radius * std::tan(tilt);
  // A nose that sinks presses in front of the centre, a side that rises behind it.
  return std::max(std::abs(skin.moment()[1] / (arm * skin.force(0)) - 1),
                  std::abs(skin.moment()[0] / (arm * skin.force(0)) - 1));
}

mechanics::ContactSolution solved(Case input, const Options& options) {
  settle_pose(input);
  mechanics::ContactOptions contact;
  contact.threads = options.threads;
  base::Timers timers;
  return mechanics::solve_contact(input, contact, timers);
}

/// Largest difference of the wrench, over the normal force, between a tilted block turned by a
/// quarter and the same block with its sides and its tilt exchanged, on the way along y.
double quarter_turn(const Options& options) {
  Case turned = baseline_case();
  turned.skin.length = turned.skin.width = 3e-3;
  turned.slider.size = {1e-3, 0.7e-3};
  turned.slider.start = {1.4e-3, 1.2e-3};
  turned.slider.pose = {1e-4, 2e-4, pi / 2};
  turned.motion.direction = {0, 1};
  turned.motion.stroke = 0.3e-3;
  turned.motion.cycles = 1;
  turned.numerics.mesh_refinement = 0.5;
  Case exchanged = turned;
  exchanged.slider.size = {0.7e-3, 1e-3};
  // The own x of the turned one is along y, its own y against x.
  exchanged.slider.pose = {-turned.slider.pose.pitch, turned.slider.pose.roll, 0};
  const auto one = solved(turned, options), other = solved(exchanged, options);
  double largest = one.stepped.size() == other.stepped.size() ? 0 : 1;
  for (std::size_t i = 0; i < one.stepped.size() && largest < 1; ++i) {
    const auto &a = one.stepped[i].state, &b = other.stepped[i].state;
    if (!a || !b) {
      continue;
    }
    largest = std::max(largest, std::abs(a->normal_force / b->normal_force - 1));
    for (std::size_t c = 0; c < 3; ++c) {
      largest = std::max(largest, std::abs(a->moment[c] - b->moment[c]) / (1e-3 * b->normal_force));
    }
  }
  return largest;
}

/// Centres and widths of the halves of columns between lines [m].
std::vector<std::array<double, 2>> halves(const std::vector<double>& lines) {
  std::vector<std::array<double, 2>> result;
  for (std::size_t i = 0; i + 1 < lines.size(); ++i) {
    const double half = (lines[i + 1] - lines[i]) / 2;
    result.push_back({lines[i] + half / 2, half});
    result.push_back({lines[i + 1] - half / 2, half});
  }
  return result;
}

/// Moments of the stress through each level of the core about the slider's centre on the top face,
/// docs/model.md (79), less those of the tractions: largest over the levels and the given instants,
/// over the largest moment of the tractions. The stress is that of the strain that is recovered;
/// far from the slider little of it has arms of millimetres.
double moment_imbalance(const mechanics::ContactSolution& solution, const Case& input,
                        const std::vector<double>& instants) {
  const Layer& core = input.skin.layers[input.skin.core_index()];
  const double nu = core.material.poissons_ratio,
               shear = core.material.youngs_modulus / (2 * (1 + nu)),
               lame = 2 * shear * nu / (1 - 2 * nu);
  const double top = input.skin.thickness();
  double largest = 0, imbalance = 0;
  for (const double time : instants) {
    const auto& instant = *std::ranges::min_element(
        solution.stepped, {}, [&](const auto& at) { return std::abs(at.time - time); });
    const mechanics::CoreStrain strain =
        instant.state->source->all_layers()(instant.state->place).core;
    const mesh::MeshLines lines = solution.mesh.lines(instant.centre);
    const auto x = halves(lines.x), y = halves(lines.y);
    const std::size_t first = solution.mesh.core_z()[0];
    for (std::size_t level = 0; level < strain.points[2]; ++level) {
      // Gauss' points of each element through the core, two in each.
      const std::size_t row = first + level / 2;
      const double size = lines.z[row + 1] - lines.z[row];
      const double height =
          lines.z[row] + size / 2 + (level % 2 == 0 ? -0.5 : 0.5) * size / std::sqrt(3.0) - top;
      std::array<double, 3> moment{};
      for (std::size_t j = 0; j < y.size(); ++j) {
        for (std::size_t i = 0; i < x.size(); ++i) {
          const std::size_t at = i + x.size() * (j + y.size() * level);
          const auto e = [&](std::size_t c) { return strain.component[c][at]; };
          const double area = x[i][1] * y[j][1], arm_x = x[i][0] - instant.centre[0],
                       arm_y = y[j][0] - instant.centre[1];
          const double zz = lame * (e(0) + e(1) + e(2)) + 2 * shear * e(2), yz = 2 * shear * e(3),
                       xz = 2 * shear * e(4);
          moment[0] += area * (arm_y * zz - height * yz);
          moment[1] += area * (height * xz - arm_x * zz);
          moment[2] += area * (arm_x * yz - arm_y * xz);
        }
      }
      for (std::size_t c = 0; c < 3; ++c) {
        largest = std::max(largest, std::abs(instant.state->moment[c]));
        imbalance = std::max(imbalance, std::abs(moment[c] - instant.state->moment[c]));
      }
    }
  }
  return imbalance / largest;
}

/// Imbalance of moments for a tilted ball off the middle of a skin, pressed, turned in place, and
/// drawn on.
double moments_through_levels(const Options& options) {
  Case input = baseline_case();
  input.skin.length = 5e-3;
  input.skin.width = 4e-3;
  input.slider.shape = "sphere";
  input.slider.parameters["radius"] = 8e-3;
  input.slider.size = {16e-3, 16e-3};
  input.numerics.mesh_refinement = 0.5;
  input.motion.cycles = 1;
  input.motion.kind = MotionKind::waypoints;
  const std::array<double, 2> place{2.2e-3, 1.7e-3}, end{2.5e-3, 1.8e-3};
  input.motion.waypoints = {{0, place, 1e-6, {}},
                            {0.2, place, -4e-6, {}},
                            {0.4, place, -4e-6, {}},
                            {0.6, end, -4e-6, {}}};
  for (std::size_t i = 0; i < 4; ++i) {
    input.motion.waypoints[i].pitch = 0.01;
    input.motion.waypoints[i].yaw = i < 2 ? 0.0 : 0.2;
  }
  settle_pose(input);
  return moment_imbalance(solved(input, options), input, {0.2, 0.4, 0.6});
}

} // namespace

std::vector<Row> pose_rows(const Options& options) {
  std::array<double, 3> punch{};
  std::array<SphereSpin, 2> spin;
  double sphere = 0, quarter = 0, levels = 0;
  const std::array<std::function<void()>, 8> solves{
      [&] { levels = moments_through_levels({.threads = 1}); },
      [&] { spin[1] = sphere_spin(2); },
      [&] { spin[0] = sphere_spin(1); },
      [&] { punch[2] = tilted_punch(16, 4); },
      [&] { punch[1] = tilted_punch(16, 2); },
      [&] { punch[0] = tilted_punch(16, 1); },
      [&] { sphere = tilted_sphere(); },
      [&] { quarter = quarter_turn({.threads = 1}); }};
  parallel::run_tasks(solves.size(), options.threads, [&](std::size_t i) { solves[i](); });
  std::vector<Row> rows;
  rows.push_back(compare("M17", "tilted flat punch on a block: moment over the half-space's",
                         punch[2], 1, 0.01));
  rows.push_back(at_least("M17", "the same: observed order in the size of the cells",
                          std::log2((punch[1] - punch[0]) / (punch[2] - punch[1])), 0.8));
  rows.push_back(
      compare("M17", "tilted sphere: moment over force times the arm, error", sphere, 0, 0.01));
  rows.push_back(compare("M17", "spinning sphere, half stuck: torque over Lubkin's",
                         spin[1].partial, 1, 0.02));
  rows.push_back(compare("M17", "spinning sphere, full slip: torque over 3 pi mu P a / 16",
                         spin[1].full, 1, 0.01));
  rows.push_back(at_least("M17", "the same: observed order in the size of the cells",
                          std::log2((1 - spin[0].full) / (1 - spin[1].full)), 0.5));
  rows.push_back(
      at_most("M17", "turn by a quarter against exchanged sides, wrench", quarter, 1e-9));
  rows.push_back(
      at_most("M17", "moments of tractions less those of stress through the core", levels, 0.02));
  return rows;
}

} // namespace ionskin::verification
