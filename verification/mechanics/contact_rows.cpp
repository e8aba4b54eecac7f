// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/elasticity/core_strain.hpp"
#include "ionskin/mechanics/path/slider_track.hpp"
#include "ionskin/mechanics/solve_contact.hpp"
#include "mechanics/baseline_case.hpp"
#include "mechanics/rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace ionskin::verification {
namespace {

using mechanics::ContactSolution;
using mechanics::ContactState;

/// Middle and half width of the ranges spanned by two independent finite element codes and a
/// spectral one on fine meshes.
struct Reference {
  double friction;
  double touchdown_force, touchdown_force_range; // [N]
  double touchdown_shear;
  double slide_force, slide_force_range; // [N]
  double slide_shear, slide_shear_range;
  double full_slip_travel; // [m]
};
constexpr Reference references[] = {
    {0.05, 66.0, 0.3, 2.60e-3, 65.05, 0.15, 3.08e-3, 0.0, 0.9e-6},
    {0.3, 68.3, 0.5, 2.54e-3, 65.0, 0.3, 8.475e-3, 0.025e-3, 5.4e-6},
    {0.5, 68.4, 0.5, 2.535e-3, 64.7, 0.3, 1.3395e-2, 0.045e-3, 9e-6}};
/// Discretisation error granted to the coarse preset.
constexpr double coarse_tolerance = 0.02;

// The legs of the baseline's cycle.
constexpr std::size_t touchdown_leg = 0, slide_leg = 1, lift_leg = 2;

double travel(const Case& input, const mechanics::PathState& point) {
  return input.motion.stroke * point.time / input.motion.slide;
}

double mean_shear(const Case& input, const ContactSolution& solution, const ContactState& state,
                  double arc_length) {
  const auto lines = solution.mesh.lines(mechanics::SliderTrack(input).centre(arc_length));
  return 2 * mechanics::off_diagonal_shear_integral(state.strain, lines, solution.mesh.core_z()) /
         input.skin.core_volume();
}

/// M6: forces and mean shear against the reference ranges.
void add_baseline_rows(const Case& input, const Reference& reference,
                       const ContactSolution& solution, std::vector<Row>& rows) {
  const auto add = [&](const char* quantity, double value, double expected, double range) {
    rows.push_back(compare("M6", fmt::format("{} at mu = {}", quantity, reference.friction), value,
                           expected, range + coarse_tolerance * expected));
  };
  const ContactState& touchdown = *solution.legs[touchdown_leg].last();
  const auto& steady = solution.legs[slide_leg].steady;
  const mechanics::PathState& slide = steady[steady.size() / 2];
  add("normal force after touchdown [N]", touchdown.normal_force, reference.touchdown_force,
      reference.touchdown_force_range);
  add("mean shear after touchdown", mean_shear(input, solution, touchdown, 0),
      reference.touchdown_shear, 0);
  add("normal force in mid-slide [N]", slide.state->normal_force, reference.slide_force,
      reference.slide_force_range);
  add("mean shear in mid-slide", mean_shear(input, solution, *slide.state, travel(input, slide)),
      reference.slide_shear, reference.slide_shear_range);
}

/// M7: slider travel at which the friction force comes within 0.1 % of its limit.
Row full_slip_row(const Case& input, const Reference& reference, const ContactSolution& solution) {
  const auto& onset = solution.legs[slide_leg].path;
  const auto lag = [&](const mechanics::PathState& point) {
    return 1 - point.state->tangential_force[0] / (reference.friction * point.state->normal_force);
  };
  const auto after = std::find_if(onset.begin() + 2, onset.end(),
                                  [&](const auto& point) { return lag(point) < 1e-3; });
  const auto before = after - 1;
  const double part = std::log(lag(*before) / 1e-3) / std::log(lag(*before) / lag(*after));
  const double begin = travel(input, *before);
  const double full_slip = begin + part * (travel(input, *after) - begin);
  return compare("M7", fmt::format("travel to full slip at mu = {} [um]", reference.friction),
                 full_slip * 1e6, reference.full_slip_travel * 1e6,
                 0.15 * reference.full_slip_travel * 1e6);
}

/// M4 and M5 over every converged state.
void add_condition_rows(double friction, const ContactSolution& solution, std::vector<Row>& rows) {
  double full_slip = 0;
  for (const auto& point : solution.legs[slide_leg].steady) {
    const double limit = friction * point.state->normal_force;
    full_slip = std::max(full_slip, std::abs(point.state->tangential_force[0] / limit - 1));
  }
  const auto name = [&](const char* quantity) {
    return fmt::format("{} at mu = {}", quantity, friction);
  };
  rows.push_back(at_most("M4", name("|T / (mu N) - 1| in full slip"), full_slip, 1e-8));
  rows.push_back(at_most("M4", name("contact forces against base reactions"),
                         solution.worst_equilibrium_residual, 1e-9));
  rows.push_back(at_most("M5", name("worst tension, penetration, cone or slip violation"),
                         solution.worst_complementarity_residual, 1e-8));
}

/// Over the states behind the first, which belongs to the leg before.
double largest_difference(const std::vector<mechanics::PathState>& a,
                          const std::vector<mechanics::PathState>& b) {
  double difference = 0, scale = 0;
  for (std::size_t i = 1; i < a.size(); ++i) {
    for (std::size_t c = 0; c < a[i].state->normal_traction.size(); ++c) {
      const ContactState &one = *a[i].state, &other = *b[i].state;
      scale = std::max(scale, one.normal_traction[c]);
      difference =
          std::max({difference, std::abs(one.normal_traction[c] - other.normal_traction[c]),
                    std::abs(one.tangential_traction_x[c] - other.tangential_traction_x[c]),
                    std::abs(one.tangential_traction_y[c] - other.tangential_traction_y[c])});
    }
  }
  return difference / scale;
}

/// M8: the second cycle, solved from where the first ended, repeats it.
void add_cycle_rows(Case input, const ContactSolution& first, const Options& options,
                    std::vector<Row>& rows) {
  mechanics::ContactOptions contact;
  contact.threads = options.threads;
  contact.nodes = first.legs[slide_leg].steady.size();
  contact.surface_before = first.final_surface;
  base::Timers timers;
  const ContactSolution second = mechanics::solve_contact(input, contact, timers);
  const auto difference = [&](std::size_t leg) {
    return largest_difference(first.legs[leg].path, second.legs[leg].path);
  };
  rows.push_back(at_most("M8", "second cycle against first: tractions after touchdown",
                         difference(touchdown_leg), 1e-8));
  rows.push_back(at_most("M8", "second cycle against first: tractions during onset",
                         difference(slide_leg), 1e-8));
  double left = 0;
  for (const double force : first.legs[lift_leg].last()->normal_traction) {
    left = std::max(left, std::abs(force));
  }
  rows.push_back(at_most("M8", "normal traction left after lift-off [Pa]", left, 1e-6));
}

} // namespace

std::vector<Row> contact_rows(const Options& options) {
  const Case input = baseline_case();
  std::vector<double> frictions;
  for (const Reference& reference : references) {
    frictions.push_back(reference.friction);
  }
  mechanics::ContactOptions contact;
  contact.threads = options.threads;
  contact.progress = options.progress;
  contact.nodes = 5; // an odd count puts a node in mid-slide
  base::Timers timers;
  const auto solutions = mechanics::solve_contact(input, frictions, contact, timers);

  std::vector<Row> rows;
  for (std::size_t i = 0; i < solutions.size(); ++i) {
    add_condition_rows(frictions[i], solutions[i], rows);
    add_baseline_rows(input, references[i], solutions[i], rows);
    rows.push_back(full_slip_row(input, references[i], solutions[i]));
  }
  add_cycle_rows(input, solutions[1], options, rows);
  return rows;
}

} // namespace ionskin::verification
