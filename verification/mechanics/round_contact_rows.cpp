// SPDX-License-Identifier: Apache-2.0
#include "mechanics/pressed_skin.hpp"
#include "mechanics/rows.hpp"

#include "ionskin/parallel/task_pool.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <functional>
#include <numbers>

namespace ionskin::verification {
namespace {

using std::numbers::pi;

constexpr double youngs_modulus = 1e9;      // [Pa]
constexpr double radius = 10e-3;            // of the slider [m]
constexpr double round_indentation = 10e-6; // [m]
constexpr double contact_estimate = 316e-6; // sqrt(radius * round_indentation) [m]

/// Case of a block of one material, some contact radii deep and four times as wide.
Case block(const std::string& shape, double depth_ratio, double poissons_ratio, double friction) {
  const Material material{"block", youngs_modulus, poissons_ratio};
  const double depth = depth_ratio * contact_estimate;
  Case input;
  input.skin.length = input.skin.width = 4 * depth;
  input.skin.layers = {{"lower", LayerRole::electrode, material, 0.3 * depth},
                       {"middle", LayerRole::core, material, 0.4 * depth},
                       {"upper", LayerRole::electrode, material, 0.3 * depth}};
  input.slider.shape = shape;
  input.slider.parameters["radius"] = radius;
  input.slider.size = {2 * radius, 2 * radius};
  if (shape == "cylinder") {
    input.skin.width = 1e-3;
    input.skin.sides = SideCondition::symmetry;
  }
  input.slider.start = {input.skin.length / 2, input.skin.width / 2};
  input.motion.preload = round_indentation;
  input.contact.friction = friction;
  input.numerics.preset = Preset::coarse;
  return input;
}

double plane_modulus(double poissons_ratio) {
  return youngs_modulus / (1 - poissons_ratio * poissons_ratio);
}

/// Contact radius under a force (Hertz 1882; Johnson, Contact Mechanics, 1985, chapter 4).
double hertz_radius(double force, double poissons_ratio) {
  return std::cbrt(0.75 * force * radius / plane_modulus(poissons_ratio));
}

/// Computed values over those of the half-space under the same force.
struct HertzRatios {
  double radius = 0, pressure = 0;
};

/// Ratios of a sphere to Hertz.
/// @param soft true for a sphere of the block's material, false for a rigid sphere
HertzRatios sphere_ratios(double depth_ratio, bool soft) {
  constexpr double nu = 0.3;
  Case input = block("sphere", depth_ratio, nu, 0);
  if (soft) {
    input.slider.youngs_modulus = youngs_modulus;
    input.slider.poissons_ratio = nu;
  }
  input.numerics.mesh_refinement = 1.25; // the contact's border is found within 0.15 of a cell
  PressedSkin skin(input);
  skin.advance({0, 0});
  // Two bodies alike are half as stiff together as one on a rigid one.
  const double expected = hertz_radius((soft ? 2 : 1) * skin.force(0), nu);
  return {std::sqrt(skin.contact_area() / pi) / expected,
          skin.central_pressure(expected) / (1.5 * skin.force(0) / (pi * expected * expected))};
}

HertzRatios cylinder_ratios(double depth_ratio) {
  constexpr double nu = 0.3;
  Case input = block("cylinder", depth_ratio, nu, 0);
  input.numerics.mesh_refinement = 6;
  PressedSkin skin(input);
  skin.advance({0, 0});
  const double force = skin.force(0) / input.skin.width;
  const double expected = std::sqrt(4 * force * radius / (pi * plane_modulus(nu)));
  return {skin.contact_area() / (2 * input.skin.width) / expected,
          skin.central_pressure(expected) / (2 * force / (pi * expected))};
}

/// Extrapolates a value to infinite depth from blocks of which the second is twice as deep; the
/// error falls like radius over depth.
double at_infinite_depth(double shallow, double deep) {
  return 2 * deep - shallow;
}

void add_hertz_rows(const char* shape, const HertzRatios& shallow, const HertzRatios& deep,
                    std::vector<Row>& rows) {
  rows.push_back(compare("M2", fmt::format("{} on a block: contact radius over Hertz's", shape),
                         at_infinite_depth(shallow.radius, deep.radius), 1, 0.01));
  rows.push_back(compare("M2", fmt::format("{} on a block: peak pressure over Hertz's", shape),
                         at_infinite_depth(shallow.pressure, deep.pressure), 1, 0.01));
}

/// Partial slip under a tangential displacement (Cattaneo 1938, Mindlin 1949; Johnson, Contact
/// Mechanics, 1985, section 7.2).
struct PartialSlip {
  /// Computed less expected stick radius over the contact radius; the depth hardly changes it.
  double stick_error = 0;
  double compliance = 0; ///< displacement over that of the half-space under the same forces
};

/// Partial slip of a sphere. The theory assumes that pressure moves nothing sideways, as for a
/// rigid sphere on a nearly incompressible block or two identical bodies, and leaves out slip
/// across the load, of which there is none without Poisson's ratio.
/// @param bodies number of deformable bodies: 1, the block; 2, the sphere as well
PartialSlip partial_slip(double depth_ratio, double nu, int bodies) {
  constexpr double mu = 0.3, part_of_full_slip = 0.6;
  constexpr int steps = 3;
  const double shear_modulus = youngs_modulus / (2 * (1 + nu));
  Case input = block("sphere", depth_ratio, nu, mu);
  if (bodies == 2) {
    input.slider.youngs_modulus = youngs_modulus;
    input.slider.poissons_ratio = nu;
  }
  PressedSkin skin(input);
  skin.advance({0, 0});
  const auto contact_radius = [&] { return hertz_radius(bodies * skin.force(0), nu); };
  const auto full_slip = [&] {
    return bodies * 3 * (2 - nu) * mu * skin.force(0) / (16 * shear_modulus * contact_radius());
  };
  const double travel = part_of_full_slip * full_slip();
  for (int i = 0; i < steps; ++i) {
    skin.advance({travel / steps, 0});
  }
  const double reserve = 1 - skin.force(1) / (mu * skin.force(0));
  return {std::sqrt(skin.stick_area() / pi) / contact_radius() - std::cbrt(reserve),
          travel / (full_slip() * (1 - std::pow(reserve, 2.0 / 3)))};
}

/// Error of a cylinder's stick half-width over the contact's, computed less expected. It is exact
/// on the half-space (Cattaneo 1938; Johnson, Contact Mechanics, 1985, section 7.2), unlike the
/// sphere's, whose slip has a part across that the theory leaves out.
double cylinder_stick_error(double depth_ratio) {
  constexpr double nu = 0.4999, mu = 0.3, least_reserve = 0.5, step = 0.05; // of the indentation
  Case input = block("cylinder", depth_ratio, nu, mu);
  input.numerics.mesh_refinement = 6;
  PressedSkin skin(input);
  skin.advance({0, 0});
  double reserve = 1;
  while (reserve > least_reserve) {
    skin.advance({step * round_indentation, 0});
    reserve = 1 - skin.force(1) / (mu * skin.force(0));
  }
  return skin.stick_area() / skin.contact_area() - std::sqrt(reserve);
}

} // namespace

std::vector<Row> round_contact_rows(const Options& options) {
  std::array<HertzRatios, 2> cylinder, sphere, soft_sphere;
  std::array<PartialSlip, 2> slip; // shallow, deep
  PartialSlip alike;
  std::array<double, 2> cylinder_stick{};
  const std::array<std::function<void()>, 11> solves{
      [&] { slip[1] = partial_slip(12, 0.4999, 1); },
      [&] { soft_sphere[1] = sphere_ratios(8, true); },
      [&] { sphere[1] = sphere_ratios(8, false); },
      [&] { slip[0] = partial_slip(6, 0.4999, 1); },
      [&] { alike = partial_slip(6, 0, 2); },
      [&] { soft_sphere[0] = sphere_ratios(4, true); },
      [&] { sphere[0] = sphere_ratios(4, false); },
      [&] { cylinder[1] = cylinder_ratios(16); },
      [&] { cylinder[0] = cylinder_ratios(8); },
      [&] { cylinder_stick[1] = cylinder_stick_error(16); },
      [&] { cylinder_stick[0] = cylinder_stick_error(8); }};
  parallel::run_tasks(solves.size(), options.threads, [&](std::size_t i) { solves[i](); });
  std::vector<Row> rows;
  add_hertz_rows("cylinder", cylinder[0], cylinder[1], rows);
  add_hertz_rows("sphere", sphere[0], sphere[1], rows);
  add_hertz_rows("soft sphere", soft_sphere[0], soft_sphere[1], rows);
  rows.push_back(compare("M2", "Cattaneo: stick half-width less the expected one, over contact's",
                         at_infinite_depth(cylinder_stick[0], cylinder_stick[1]), 0, 0.01));
  rows.push_back(compare("M2", "Cattaneo-Mindlin: error of the stick radius over contact radius",
                         slip[1].stick_error, 0, 0.02));
  rows.push_back(compare("M2", "the same of two bodies alike without Poisson's ratio",
                         alike.stick_error, 0, 0.01));
  rows.push_back(compare("M2", "Cattaneo-Mindlin: tangential compliance over Mindlin's",
                         at_infinite_depth(slip[0].compliance, slip[1].compliance), 1, 0.02));
  return rows;
}

} // namespace ionskin::verification
