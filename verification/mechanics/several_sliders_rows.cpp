// SPDX-License-Identifier: Apache-2.0
#include "ionskin/case/elastic_constants.hpp"
#include "ionskin/finite_layers/skin/layered_skin.hpp"
#include "ionskin/handover/sliders/sliders_history.hpp"
#include "ionskin/history/shear_statistics.hpp"
#include "ionskin/mechanics/solve_sliders.hpp"
#include "mechanics/rows.hpp"

#include <Eigen/Cholesky>

#include <algorithm>
#include <array>
#include <cmath>

namespace ionskin::verification {
namespace {

using finite_layers::CellFields;
using finite_layers::ContactGrid;
using mechanics::ContactSolution;

constexpr double thickness = 1e-3, middle_x = 5e-3, middle_y = 1e-3, side = 1e-3;
constexpr double depth = 1e-6; // [m]

/// Case of a block off the middle of a thick narrow skin, which lands at a time and stays.
Case block_at(double offset, double lands, double friction) {
  const Material material{"block", 1e6, 0.4};
  Case input;
  input.skin.length = 2 * middle_x;
  input.skin.width = 2 * middle_y;
  input.skin.layers = {{"lower", LayerRole::electrode, material, 0.3 * thickness},
                       {"middle", LayerRole::core, material, 0.4 * thickness},
                       {"upper", LayerRole::electrode, material, 0.3 * thickness}};
  input.slider.size = {side, side};
  input.slider.start = {middle_x + offset, middle_y};
  input.contact.friction = friction;
  input.motion.kind = MotionKind::waypoints;
  input.motion.cycles = 1;
  const std::array<double, 2> place = input.slider.start;
  input.motion.waypoints = {{0, place, depth, {}},
                            {lands, place, depth, {}},
                            {lands + 0.2, place, -depth, {}},
                            {1, place, -depth, {}}};
  input.numerics.preset = Preset::coarse;
  return input;
}

/// Case of such a block that moves along x in the end.
Case moving_block(double offset, double travel) {
  Case input = block_at(offset, 0.1, 0.3);
  const std::array<double, 2> place = input.slider.start;
  input.motion.waypoints = {{0, place, depth, {}},
                            {0.5, place, -depth, {}},
                            {1, {place[0] + travel, place[1]}, -depth, {}}};
  return input;
}

std::vector<ContactSolution> solve_together(const std::vector<Case>& sliders,
                                            const Options& options) {
  mechanics::ContactOptions contact;
  contact.threads = options.threads;
  contact.full_model = true; // as the matrix of all cells
  base::Timers timers;
  return mechanics::solve_sliders(sliders, contact, timers);
}

const mechanics::ContactState& last(const ContactSolution& solution) {
  return *solution.stepped.back().state;
}

/// Contact grid that holds the cells of two blocks, with a column between them, which stays free,
/// for the gap.
ContactGrid grid_of_both(const ContactSolution& one, double offset) {
  ContactGrid both{{}, one.cell_lines_y};
  for (const double centre : {-offset, offset}) {
    for (const double x : one.cell_lines_x) {
      both.x.push_back(centre + x);
    }
  }
  return both;
}

/// Normal force of one of two equal blocks without friction, on the matrix of all their cells [N].
/// @param clearance half of the reach of short waves [m]
double force_by_matrix(const Case& input, const ContactSolution& one, double offset,
                       double clearance) {
  const ContactGrid both = grid_of_both(one, offset);
  const finite_layers::LayeredSkin skin(
      input.skin, both, finite_layers::skin_resolution(input.skin, {clearance, clearance}));
  const Eigen::MatrixXd all = skin.across(middle_y).compliance(middle_x);
  std::vector<Eigen::Index> pressed;
  const auto gap = static_cast<Eigen::Index>(one.cell_lines_x.size()) - 1;
  for (Eigen::Index cell = 0; cell < both.count(); ++cell) {
    if (cell % both.columns() != gap) {
      pressed.push_back(3 * cell);
    }
  }
  const Eigen::MatrixXd normal = all(pressed, pressed);
  const Eigen::VectorXd force =
      normal.ldlt().solve(Eigen::VectorXd::Constant(normal.rows(), depth));
  return 0.5 * force.sum();
}

/// Arbitrary forces on cells [N].
CellFields any_forces(const ContactGrid& cells, double phase) {
  CellFields result;
  for (std::size_t c = 0; c < 3; ++c) {
    result[c].resize(cells.columns(), cells.rows());
    for (Eigen::Index i = 0; i < cells.count(); ++i) {
      result[c].data()[i] =
          std::sin(phase + 2.3 * static_cast<double>(c + 1) + 1.7 * static_cast<double>(i));
    }
  }
  return result;
}

/// Relative difference between the works of two sets of forces, each on the displacement that the
/// other makes (Betti).
double reciprocity(const Case& input) {
  const ContactGrid one{{-0.5e-3, -0.1e-3, 0.5e-3}, {-0.4e-3, 0.1e-3, 0.5e-3}},
      other{{-0.2e-3, 0.1e-3, 0.2e-3}, {-0.5e-3, 0, 0.2e-3, 0.5e-3}};
  const auto resolution = finite_layers::skin_resolution(input.skin, {1e-3, 0.5e-3});
  const finite_layers::LayeredSkin of_one(input.skin, one, resolution),
      of_other(input.skin, other, resolution);
  const std::array<double, 2> place{1.6e-3, 0.9e-3}, other_place{4e-3, 1.1e-3};
  const CellFields forces = any_forces(one, 0.2), other_forces = any_forces(other, 0.9);
  const CellFields by_other = of_one.moved_by(other, other_place, other_forces, place),
                   by_one = of_other.moved_by(one, place, forces, other_place);
  double work = 0, other_work = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    work += forces[c].cwiseProduct(by_other[c]).sum();
    other_work += other_forces[c].cwiseProduct(by_one[c]).sum();
  }
  return std::abs(work / other_work - 1);
}

/// Mean shear of the core at the end of the cycle over that which carries the forces of all sliders
/// through it.
double shear_by_forces(const std::vector<Case>& sliders,
                       const std::vector<ContactSolution>& solutions) {
  const history::CoreHistory history = handover::build_sliders_history(sliders, solutions);
  double force = 0;
  for (const ContactSolution& solution : solutions) {
    force += last(solution).tangential_force[0];
  }
  const Skin& skin = sliders.front().skin;
  const double modulus = shear_modulus(skin.layers[skin.core_index()].material);
  const double expected = force / (skin.length * skin.width * modulus);
  return history::shear_statistics(history, history.time.back()).mean / expected;
}

} // namespace

std::vector<Row> several_sliders_rows(const Options& options) {
  constexpr double near = 1.1e-3, far = 3e-3;
  std::vector<Row> rows;
  const Case left = block_at(-near, 0.1, 0), right = block_at(near, 0.6, 0);
  const auto both = solve_together({left, right}, options);
  const double alone = last(solve_together({left}, options).front()).normal_force;
  const double expected = force_by_matrix(left, both[0], near, middle_y - side / 2),
               across_gap = force_by_matrix(left, both[0], near, thickness);
  const double first = last(both[0]).normal_force, second = last(both[1]).normal_force;
  rows.push_back(compare("M18",
                         "a block at rest, another lands beside it: change of its force over that "
                         "by the matrix of all cells",
                         (first - alone) / (expected - alone), 1, 0.02));
  rows.push_back(compare("M18", "the same of the block that lands",
                         (second - alone) / (expected - alone), 1, 0.02));
  rows.push_back(compare("M18", "the same by a matrix whose short waves reach over the gap",
                         (first - alone) / (across_gap - alone), 1, 0.05));
  rows.push_back(at_least("M18", "the same: change of the force over the force",
                          std::abs(expected / alone - 1), 1e-3));
  rows.push_back(at_most("M18", "work of two sliders on each other's displacement, difference",
                         reciprocity(left), 1e-9));

  const auto mirrored =
      solve_together({moving_block(-near, -2e-5), moving_block(near, 2e-5)}, options);
  rows.push_back(at_most(
      "M18", "two blocks drawn apart: sum of their forces along the way over one",
      std::abs(last(mirrored[0]).tangential_force[0] / last(mirrored[1]).tangential_force[0] + 1),
      1e-4));

  Case ahead = moving_block(near, 2e-5), behind = moving_block(-near, 2e-5);
  ahead.coupling.measure = behind.coupling.measure = "signed-xz";
  const auto together = solve_together({behind, ahead}, options);
  rows.push_back(compare("M18",
                         "two blocks drawn the same way: mean of their shear by their forces",
                         shear_by_forces({behind, ahead}, together), 1, 0.01));

  const auto apart = solve_together({block_at(-far, 0.1, 0.3), block_at(far, 0.1, 0.3)}, options);
  const auto by_itself = solve_together({block_at(far, 0.1, 0.3)}, options);
  rows.push_back(at_most(
      "M18", "two blocks, middles six thicknesses apart, against one, normal force, relative",
      std::abs(last(apart[1]).normal_force / last(by_itself[0]).normal_force - 1), 1e-3));
  return rows;
}

} // namespace ionskin::verification
