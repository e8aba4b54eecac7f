// SPDX-License-Identifier: Apache-2.0
#include "mechanics/rows.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/mechanics/engine/adhesion_resolution.hpp"
#include "ionskin/mechanics/engine/sliding_contact.hpp"
#include "ionskin/mechanics/skin/skin_model.hpp"
#include "ionskin/parallel/task_pool.hpp"

#include <Eigen/QR>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace ionskin::verification {
namespace {

using std::numbers::pi;

// A rubber sphere's work: 25 mJ/m2 on 1 MPa.
constexpr double block_modulus = 1e6, block_ratio = 0.3; // [Pa], [1]
constexpr double sphere_radius = 10e-3;                  // [m]
constexpr double pull_off_radius = 200e-6;               // of the contact, by JKR [m]
constexpr double plane = block_modulus / (1 - block_ratio * block_ratio); // [Pa]
/// Work of adhesion w at which the pull-off radius is a = (9 pi w R^2 / (8 E*))^(1/3).
const double work_of_adhesion =
    8 * plane * std::pow(pull_off_radius, 3) / (9 * pi * sphere_radius * sphere_radius);
/// Unit of heights, a^2/R [m]. By JKR the force is least at -1/3 of the unit, and the contact under
/// a given height comes off at -0.69.
constexpr double height_unit = pull_off_radius * pull_off_radius / sphere_radius;
/// Indentation from which the slider is pulled off, in units of `height_unit`; the contact is then
/// a quarter wider than at pull-off.
constexpr double pressed = 0.1;

/// Strength of adhesion s0 at a transition parameter of Maugis 1992, doi
/// 10.1016/0021-9797(92)90285-T: lambda = 2 s0 / (pi w K^2 / R)^(1/3), K = 4 E* / 3.
double strength_of(double transition) {
  const double k = 4 * plane / 3;
  return 0.5 * transition * std::cbrt(pi * work_of_adhesion * k * k / sphere_radius);
}

/// Pull-off force over pi w R of an adhesion with constant traction: the fit to Maugis' curve of
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
  double force = 0;     ///< largest pull, over pi w R
  double scatter = 0;   ///< scatter of the pulls about the parabola, over pi w R
  double let_go = 0;    ///< height at which the sphere comes off, over a^2 / R
  double cell = 0;      ///< size of a cell, over the contact radius at pull-off
  bool refused = false; ///< true if a run refuses cells of this size
};

bool refuses(const Case& input, const mechanics::SkinModel& model) {
  std::vector<std::string> warnings;
  try {
    mechanics::require_resolved_adhesion(input, model, model.places, warnings);
    return false;
  } catch (const SolverError&) {
    return true;
  }
}

/// Presses the sphere and raises it in small steps until nothing holds. Cells let go one by one,
/// which ripples the force: the largest pull is that of the least-squares parabola through the
/// heights around it.
PullOff pull_off(double transition, double refinement) {
  constexpr double way = 0.05, crest_begin = -0.01, crest_end = 0.51;
  constexpr double widest = 1.45 * pull_off_radius;
  const Case input = adhesive_block(transition, refinement);
  const mechanics::SkinModel model(input, {{widest, widest}, {widest, widest}},
                                   {input.slider.start, input.slider.start});
  PullOff result;
  result.refused = refuses(input, model);
  mechanics::ContactCompliance compliance(model);
  mechanics::SlidingContact contact(
      [&](const auto& place, auto& problem) { compliance.at(place, problem); }, model.cells.area,
      model.gap, laws::friction(input.contact.law, 0, input.contact.parameters));
  const double scale = (model.mesh.half_model() ? 2 : 1) / (pi * work_of_adhesion * sphere_radius);
  std::vector<double> heights, pulls;
  for (double height = -pressed; height < 2; height += way) {
    contact.step(1, input.slider.start, {mechanics::LoadKind::indentation, -height * height_unit});
    result.let_go = height;
    if (!contact.in_contact()) {
      break;
    }
    if (height > crest_begin && height < crest_end) {
      heights.push_back(height);
      pulls.push_back(-scale * mechanics::total_normal_force(contact.state().force));
    }
  }
  const auto count = static_cast<Eigen::Index>(pulls.size());
  const Eigen::Map<const Eigen::ArrayXd> height(heights.data(), count);
  const Eigen::Map<const Eigen::VectorXd> pull(pulls.data(), count);
  Eigen::MatrixXd powers(count, 3);
  powers << Eigen::ArrayXd::Ones(count), height, height.square();
  const Eigen::Vector3d fit = powers.colPivHouseholderQr().solve(pull);
  result.force = fit[0] - fit[1] * fit[1] / (4 * fit[2]);
  result.scatter = (powers * fit - pull).norm() / std::sqrt(static_cast<double>(count));
  result.cell = (model.cells.lines_x[1] - model.cells.lines_x[0]) / pull_off_radius;
  return result;
}

} // namespace

std::vector<Row> adhesion_rows(const Options& options) {
  // A longer and a shorter pull; coarser and finer cells. Those of the last a run refuses.
  struct Pull {
    double transition, refinement;
  };
  constexpr std::array<Pull, 5> pulls{{{2, 1}, {2, 1.25}, {2.5, 1.25}, {2.5, 1.5}, {2.5, 1}}};
  std::array<PullOff, pulls.size()> found;
  parallel::run_tasks(pulls.size(), options.threads, [&](std::size_t i) {
    found[i] = pull_off(pulls[i].transition, pulls[i].refinement);
  });
  std::vector<Row> rows;
  for (std::size_t i = 0; i < pulls.size(); ++i) {
    const PullOff& one = found[i];
    const double transition = pulls[i].transition;
    const std::string sphere =
        fmt::format("adhesive sphere, lambda {}, cells {:.2f} a: ", transition, one.cell);
    rows.push_back(compare("M15", sphere + "pull-off force over Maugis'",
                           one.force / maugis_force(transition), 1, 0.03));
    if (!one.refused) {
      rows.push_back(
          at_most("M15", sphere + "ripple of the force as cells let go", one.scatter, 0.05));
    }
  }
  const PullOff &finest = found[3], &finer = found[2], &coarser = found[4];
  rows.push_back(compare("M15", "adhesive sphere: pull-off force over JKR's 1.5 pi w R",
                         finest.force / 1.5, 1, 0.03));
  rows.push_back(compare("M15", "adhesive sphere: height of letting go by R / a^2, JKR's",
                         finest.let_go, 0.693, 0.1));
  rows.push_back(at_least("M15", "adhesive sphere: ripple of coarser over that of finer cells",
                          coarser.scatter / finer.scatter, 1));
  const auto refused = std::ranges::count_if(found, &PullOff::refused);
  rows.push_back(compare("M15", "adhesive sphere: pulls on cells that a run refuses",
                         static_cast<double>(refused), 1, 0));
  return rows;
}

} // namespace ionskin::verification
