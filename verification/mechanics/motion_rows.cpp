// SPDX-License-Identifier: Apache-2.0
#include "ionskin/handover/contact_timeline.hpp"
#include "ionskin/handover/energy_balance.hpp"
#include "ionskin/mechanics/output/core_strain.hpp"
#include "ionskin/mechanics/solve_contact.hpp"
#include "mechanics/baseline_case.hpp"
#include "mechanics/rows.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace ionskin::verification {
namespace {

using mechanics::ContactSolution;
using mechanics::ContactState;
using mechanics::SteppedInstant;

/// Case of a small skin on a cheap mesh, for rows that compare solutions on one mesh.
Case small_case() {
  Case input = baseline_case();
  input.skin.length = 5e-3;
  input.slider.size = {1e-3, 0.8e-3};
  input.slider.start = {1.5e-3, 1e-3};
  input.motion.stroke = 2e-3;
  input.numerics.mesh_refinement = 0.5;
  input.output.fields = {0.502, 1, 1.5, 2}; // are passed; the first one within the onset
  return input;
}

ContactSolution solve(const Case& input, const Options& options, bool full_model = false) {
  mechanics::ContactOptions contact;
  contact.threads = options.threads;
  contact.full_model = full_model;
  base::Timers timers;
  return mechanics::solve_contact(input, contact, timers);
}

const SteppedInstant& instant_at(const ContactSolution& solution, double time) {
  return *std::ranges::min_element(solution.stepped, {}, [&](const SteppedInstant& instant) {
    return std::abs(instant.time - time);
  });
}

const SteppedInstant& in_mid_slide(const ContactSolution& solution) {
  return instant_at(solution, 1.5);
}

/// Integral of the off-diagonal shear over the whole core [m3].
double shear(const ContactSolution& solution, const SteppedInstant& instant) {
  const double meshed = mechanics::off_diagonal_shear_integral(
      mechanics::core_strain(*instant.state), solution.mesh.lines(instant.centre),
      solution.mesh.core_z());
  return solution.mesh.half_model() ? 2 * meshed : meshed;
}

/// Tolerance of strains [1]. They are combined from the strains of few loads, which may leave this
/// much of a load out; forces are not.
constexpr double combined_strain = 1e-6;

struct Difference {
  double forces = 0, shear = 0; ///< relative differences of forces, and of shear
};

/// Largest relative difference of forces and shear in two solutions of the same cycle, where the
/// second may be seen in a mirror.
Difference difference(const ContactSolution& a, const ContactSolution& b,
                      const std::array<double, 2>& mirror) {
  Difference largest;
  for (const double time : {0.5, 0.502, 1.0, 1.5, 2.0, 2.5}) {
    const SteppedInstant &here = instant_at(a, time), &there = instant_at(b, time);
    const ContactState &one = *here.state, &other = *there.state;
    const double scale = one.normal_force;
    largest.forces = std::max(largest.forces, std::abs(other.normal_force - scale) / scale);
    for (std::size_t d = 0; d < 2; ++d) {
      largest.forces = std::max(
          largest.forces,
          std::abs(mirror[d] * other.tangential_force[d] - one.tangential_force[d]) / scale);
    }
    largest.shear = std::max(largest.shear, std::abs(shear(b, there) / shear(a, here) - 1));
  }
  return largest;
}

void add_difference(const std::string& quantity, const Difference& difference, double of_forces,
                    std::vector<Row>& rows) {
  rows.push_back(at_most("M9", quantity + ", forces", difference.forces, of_forces));
  rows.push_back(at_most("M9", quantity + ", shear", difference.shear, combined_strain));
}

/// Mirrors a slide along x, along y or along both.
Case mirrored(Case input, const std::array<double, 2>& mirror) {
  const std::array<double, 2> extent{input.skin.length, input.skin.width};
  for (std::size_t d = 0; d < 2; ++d) {
    if (mirror[d] < 0) {
      input.slider.start[d] = extent[d] - input.slider.start[d];
      input.motion.direction[d] *= -1;
    }
  }
  return input;
}

/// Adds rows that compare off-centre and oblique slides with their mirror images; no solution
/// contains a position and its image.
void add_mirror_rows(const Options& options, std::vector<Row>& rows) {
  const auto add = [&](const std::string& quantity, const Case& input,
                       const std::array<double, 2>& mirror) {
    const Case image = mirrored(input, mirror);
    add_difference(quantity, difference(solve(input, options), solve(image, options), mirror), 1e-8,
                   rows);
  };
  Case off_centre = small_case();
  off_centre.slider.start = {1.2e-3, 0.85e-3};
  off_centre.motion.stroke = 1e-3;
  add("off-centre slide against its mirror image", off_centre, {1, -1});
  Case oblique = off_centre;
  oblique.motion.direction = {0.96, 0.28};
  oblique.motion.stroke = 0.6e-3;
  add("oblique slide against its mirror image", oblique, {-1, -1});
}

/// Adds the row that compares the half model with the full one, which has the same elements.
void add_half_model_row(const Options& options, std::vector<Row>& rows) {
  const Case input = small_case();
  add_difference("half model against full model",
                 difference(solve(input, options), solve(input, options, true), {1, 1}), 1e-9,
                 rows);
}

/// Adds the row that compares slides along x and y of a square slider on a square skin; only the
/// numbers of elements outside the footprint differ.
void add_direction_row(const Options& options, std::vector<Row>& rows) {
  Case along_x = small_case();
  along_x.skin.width = along_x.skin.length = 3e-3;
  along_x.slider.size = {0.8e-3, 0.8e-3};
  along_x.slider.start = {1e-3, 1.5e-3};
  along_x.motion.stroke = 1e-3;
  Case along_y = along_x;
  std::swap(along_y.slider.start[0], along_y.slider.start[1]);
  along_y.motion.direction = {0, 1};
  const ContactSolution x = solve(along_x, options), y = solve(along_y, options);
  const double force =
      in_mid_slide(y).state->normal_force / in_mid_slide(x).state->normal_force - 1;
  const double sheared = shear(y, in_mid_slide(y)) / shear(x, in_mid_slide(x)) - 1;
  rows.push_back(at_most("M9", "slide along y against slide along x on a square skin, relative",
                         std::max(std::abs(force), std::abs(sheared)), 5e-3));
}

constexpr int instants_of_stroke = 10;

/// Instant of a sample within a stroke [s].
/// @param stroke number of the stroke, from 1
double instant_of_stroke(int stroke, int index) {
  const Case input = small_case();
  return input.motion.touchdown +
         input.motion.slide * (stroke - 1 + static_cast<double>(index) / instants_of_stroke);
}

/// Largest difference of the tangential force between two strokes, over its largest magnitude.
double loop_gap(const ContactSolution& solution, int stroke, int other) {
  double gap = 0, scale = 0;
  for (int i = 1; i <= instants_of_stroke; ++i) {
    const double a = instant_at(solution, instant_of_stroke(stroke, i)).state->tangential_force[0],
                 b = instant_at(solution, instant_of_stroke(other, i)).state->tangential_force[0];
    gap = std::max(gap, std::abs(a - b));
    scale = std::max(scale, std::abs(a));
  }
  return gap / scale;
}

ContactSolution rub(Case& input, double stroke, const Options& options) {
  input.motion.kind = MotionKind::reciprocating;
  input.motion.strokes = 5;
  input.motion.stroke = stroke;
  input.output.fields.clear();
  for (int i = 1; i <= input.motion.strokes; ++i) {
    for (int k = 1; k <= instants_of_stroke; ++k) {
      input.output.fields.push_back(instant_of_stroke(i, k));
    }
  }
  return solve(input, options);
}

/// Adds rows on short strokes to and fro with all their history. Where each stroke slides fully,
/// the history is forgotten. Where a part sticks throughout, the loop would close at once if normal
/// and tangential contact were uncoupled; here it settles.
void add_reversal_rows(const Options& options, std::vector<Row>& rows) {
  Case sliding = small_case();
  const ContactSolution full = rub(sliding, 5e-6, options);
  rows.push_back(at_most("M10", "reversal loop in full slip: 4th stroke against the 2nd, T",
                         loop_gap(full, 4, 2), 1e-3));
  rows.push_back(at_most("M10", "reversal loop in full slip: 5th stroke against the 3rd, T",
                         loop_gap(full, 5, 3), 1e-3));
  Case sticking = small_case();
  const ContactSolution part = rub(sticking, 2e-6, options);
  rows.push_back(at_least("M10", "reversal loop in partial slip: 3rd stroke against the first, T",
                          loop_gap(part, 3, 1), 0.5));
  rows.push_back(at_most("M10", "reversal loop in partial slip: 4th stroke against the 2nd, T",
                         loop_gap(part, 4, 2), 2e-2));
  rows.push_back(at_most("M10",
                         "reversal loop in partial slip: its change from loop to loop, ratio",
                         loop_gap(part, 5, 3) / loop_gap(part, 4, 2), 0.75));
  rows.push_back(at_most(
      "M10", "energy balance of strokes in full slip, relative",
      handover::energy_balance(handover::ContactTimeline(sliding, full), full).relative_error,
      1e-3));
}

/// Adds rows on a prescribed force in place of an indentation.
void add_force_rows(const Options& options, std::vector<Row>& rows) {
  Case input = small_case();
  input.motion.preload = 0;
  input.motion.preload_force = 1;
  const ContactSolution solution = solve(input, options);
  const handover::ContactTimeline timeline(input, solution);
  double worst = 0;
  for (const double time : timeline.sample_times()) {
    if (time >= input.motion.touchdown && time <= input.motion.touchdown + input.motion.slide) {
      worst = std::max(worst, std::abs(timeline.at(time).normal_force() - 1));
    }
  }
  rows.push_back(at_most("M11", "force control: |N - 1 N| from touchdown to the end of slide [N]",
                         worst, 1e-6));
  rows.push_back(at_most("M11", "energy balance of a cycle under force control, relative",
                         handover::energy_balance(timeline, solution).relative_error, 1e-3));
  // The indentation that was found, given instead, carries the force.
  Case given = input;
  given.motion.preload = instant_at(solution, 0.5).state->indentation;
  given.motion.preload_force = 0;
  rows.push_back(compare("M11", "normal force under the indentation found for 1 N [N]",
                         instant_at(solve(given, options), 0.5).state->normal_force, 1, 1e-8));
}

} // namespace

std::vector<Row> motion_rows(const Options& options) {
  std::vector<Row> rows;
  add_mirror_rows(options, rows);
  options.progress("mechanics: motions", 0.4);
  add_half_model_row(options, rows);
  add_direction_row(options, rows);
  options.progress("mechanics: motions", 0.7);
  add_reversal_rows(options, rows);
  add_force_rows(options, rows);
  options.progress("mechanics: motions", 1);
  return rows;
}

} // namespace ionskin::verification
