// SPDX-License-Identifier: Apache-2.0
#include "mechanics/rows.hpp"

#include "ionskin/mechanics/engine/sliding_contact.hpp"
#include "ionskin/mechanics/position/condensed_position.hpp"
#include "ionskin/parallel/task_pool.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace ionskin::verification {
namespace {

using std::numbers::pi;

// A rubber sphere's work: 25 mJ/m2 on 1 MPa.
constexpr double block_modulus = 1e6, block_ratio = 0.3; // [Pa], [1]
constexpr double sphere_radius = 10e-3;                  // [m]
constexpr double pull_off_radius = 200e-6;               // of the contact, by JKR [m]
constexpr double plane = block_modulus / (1 - block_ratio * block_ratio); // [Pa]
/// Of that radius a = (9 pi w R^2 / (8 E*))^(1/3).
const double work_of_adhesion =
    8 * plane * std::pow(pull_off_radius, 3) / (9 * pi * sphere_radius * sphere_radius);
const double jkr_force = 1.5 * pi * work_of_adhesion * sphere_radius; // [N]
/// Of heights: a^2 / R [m]. By JKR the force has its least at -1/3 of it, and the contact under a
/// given height comes off at -0.69.
constexpr double height_unit = pull_off_radius * pull_off_radius / sphere_radius;
/// Where it begins; the contact is then a quarter wider than at pull-off.
constexpr double pressed = 0.1;

/// Strength of the transition parameter of Maugis 1992, doi 10.1016/0021-9797(92)90285-T:
/// lambda = 2 s0 / (pi w K^2 / R)^(1/3), K = 4 E* / 3.
double strength_of(double transition) {
  const double k = 4 * plane / 3;
  return 0.5 * transition * std::cbrt(pi * work_of_adhesion * k * k / sphere_radius);
}

/// Pull-off force over pi w R of a constant traction in the gap: the fit to Maugis' curve of
/// Pietrement and Troyon 2000, doi 10.1006/jcis.2000.6808 (better than 1 %).
double maugis_force(double transition) {
  const double power = 4.04 * std::pow(transition, 1.4);
  return 7.0 / 4 - 0.25 * (power - 1) / (power + 1);
}

Case adhesive_block(double transition, double refinement) {
  const Material material{"block", block_modulus, block_ratio};
  // The base moves the height of a given radius and force, not the force of pull-off.
  const double depth = 6 * pull_off_radius;
  Case input;
  input.skin.length = input.skin.width = 4 * depth;
  input.skin.layers = {{"lower", LayerRole::electrode, material, 0.3 * depth},
                       {"middle", LayerRole::core, material, 0.4 * depth},
                       {"upper", LayerRole::electrode, material, 0.3 * depth}};
  input.slider.shape = "sphere";
  input.slider.parameters["radius"] = sphere_radius;
  input.slider.size = {2 * sphere_radius, 2 * sphere_radius};
  input.slider.start = {input.skin.length / 2, input.skin.width / 2};
  input.motion.preload = pressed * height_unit;
  input.contact.law = "adhesive";
  input.contact.friction = 0;
  input.contact.parameters["work_of_adhesion"] = work_of_adhesion;
  input.contact.parameters["cohesive_strength"] = strength_of(transition);
  input.numerics.preset = Preset::coarse;
  input.numerics.mesh_refinement = refinement;
  return input;
}

struct PullOff {
  double force = 0;              ///< largest pull over pi w R
  double height = 0, let_go = 0; ///< of the largest pull, and where it comes off, over a^2 / R
  double cell = 0;               ///< over the contact radius at pull-off
};

/// Pressed, then raised in small steps until nothing holds.
PullOff pull_off(double transition, double refinement) {
  constexpr double way = 0.05;
  const Case input = adhesive_block(transition, refinement);
  constexpr double widest = 1.5 * pull_off_radius;
  const mechanics::SkinModel model(input, {{widest, widest}, {widest, widest}});
  const mechanics::CondensedPosition condensed(model, input.slider.start);
  const mechanics::ComplianceMap map({{{input.slider.start[0]}, {input.slider.start[1]}}},
                                     {mechanics::contact_compliance(model, condensed)});
  mechanics::SlidingContact contact(map, model.cells.area, model.gap,
                                    laws::friction(input.contact.law, 0, input.contact.parameters));
  const double parts = model.mesh.half_model() ? 2 : 1;
  std::vector<double> heights, pulls;
  for (double height = -pressed; height < 3 && (pulls.empty() || contact.in_contact());
       height += way) {
    contact.step(1, input.slider.start, {mechanics::LoadKind::indentation, -height * height_unit});
    heights.push_back(height);
    pulls.push_back(-parts * mechanics::total_normal_force(contact.state().force));
  }
  const auto largest = static_cast<std::size_t>(
      std::max_element(pulls.begin() + 1, pulls.end() - 1) - pulls.begin());
  // The crest of the parabola through the largest and its neighbours.
  const double before = pulls[largest - 1], here = pulls[largest], behind = pulls[largest + 1];
  const double slope = (behind - before) / 2, bend = before - 2 * here + behind;
  PullOff result;
  result.force = (here - slope * slope / (2 * bend)) / (pi * work_of_adhesion * sphere_radius);
  result.height = heights[largest] - way * slope / bend;
  result.let_go = heights.back();
  result.cell = (model.cells.lines_x[1] - model.cells.lines_x[0]) / pull_off_radius;
  return result;
}

} // namespace

std::vector<Row> adhesion_rows(const Options& options) {
  // Stronger and shorter on the right; finer meshes below.
  constexpr std::array<double, 2> transitions{2, 3};
  constexpr std::array<double, 3> refinements{1, 1.5, 2.25};
  std::array<std::array<PullOff, 3>, 2> found;
  parallel::run_tasks(found.size() * refinements.size(), options.threads, [&](std::size_t i) {
    const std::size_t t = i / refinements.size(), r = i % refinements.size();
    found[t][r] = pull_off(transitions[t], refinements[r]);
  });
  std::vector<Row> rows;
  for (std::size_t t = 0; t < transitions.size(); ++t) {
    for (std::size_t r = 0; r < refinements.size(); ++r) {
      rows.push_back(compare(
          "M15",
          fmt::format("sphere, Maugis' lambda {}, cells {:.3f} of the radius: pull-off force over "
                      "1.5 pi w R of JKR",
                      transitions[t], found[t][r].cell),
          found[t][r].force / 1.5, 1, 0.03));
    }
    rows.push_back(compare(
        "M15", fmt::format("sphere, lambda {}: pull-off force over that of Maugis", transitions[t]),
        found[t].back().force / maugis_force(transitions[t]), 1, 0.03));
  }
  return rows;
}

} // namespace ionskin::verification
