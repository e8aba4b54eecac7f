// SPDX-License-Identifier: Apache-2.0
#include "ionskin/case/slider_motion.hpp"
#include "ionskin/mechanics/output/core_strain.hpp"
#include "ionskin/mechanics/solve_contact.hpp"
#include "mechanics/baseline_case.hpp"
#include "mechanics/rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace ionskin::verification {
namespace {

using mechanics::ContactSolution;
using mechanics::ContactState;

/// Reference range: middle and half width of the range spanned by two independent finite element
/// codes and a spectral one on fine meshes.
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
/// Relative discretisation error that the coarse preset is allowed.
constexpr double coarse_tolerance = 0.02;

using Instants = std::vector<const mechanics::SteppedInstant*>;

/// Instants at which the slider touches after `from` and until `to`.
Instants touching(const ContactSolution& solution, double from, double to) {
  Instants instants;
  for (const mechanics::SteppedInstant& instant : solution.stepped) {
    if (instant.state && instant.time > from && instant.time <= to) {
      instants.push_back(&instant);
    }
  }
  return instants;
}

const mechanics::SteppedInstant& nearest(const ContactSolution& solution, double time) {
  return *std::ranges::min_element(
      solution.stepped, {}, [&](const auto& instant) { return std::abs(instant.time - time); });
}

double mean_shear(const Case& input, const ContactSolution& solution,
                  const mechanics::SteppedInstant& instant) {
  const auto lines = solution.mesh.lines(instant.centre);
  return 2 *
         mechanics::off_diagonal_shear_integral(mechanics::core_strain(*instant.state), lines,
                                                solution.mesh.core_z()) /
         input.skin.core_volume();
}

/// Adds the rows M6: forces and mean shear against the reference ranges.
void add_baseline_rows(const Case& input, const Reference& reference,
                       const ContactSolution& solution, std::vector<Row>& rows) {
  const auto add = [&](const char* quantity, double value, double expected, double range) {
    rows.push_back(compare("M6", fmt::format("{} at mu = {}", quantity, reference.friction), value,
                           expected, range + coarse_tolerance * expected));
  };
  const auto &touchdown = nearest(solution, input.motion.touchdown),
             &slide = nearest(solution, input.motion.touchdown + input.motion.slide / 2);
  add("normal force after touchdown [N]", touchdown.state->normal_force, reference.touchdown_force,
      reference.touchdown_force_range);
  add("mean shear after touchdown", mean_shear(input, solution, touchdown),
      reference.touchdown_shear, 0);
  add("normal force in mid-slide [N]", slide.state->normal_force, reference.slide_force,
      reference.slide_force_range);
  add("mean shear in mid-slide", mean_shear(input, solution, slide), reference.slide_shear,
      reference.slide_shear_range);
}

/// Row M7: slider travel at which the friction force comes within 0.1 % of its limit.
Row full_slip_row(const Case& input, const Reference& reference, const ContactSolution& solution) {
  const double begin_of_slide = input.motion.touchdown;
  const Instants onset =
      touching(solution, begin_of_slide, begin_of_slide + 0.5 * input.motion.slide);
  const auto lag = [&](const mechanics::SteppedInstant* instant) {
    return 1 - instant->state->tangential_force[0] /
                   (reference.friction * instant->state->normal_force);
  };
  const auto travel = [&](const mechanics::SteppedInstant* instant) {
    return input.motion.stroke * (instant->time - begin_of_slide) / input.motion.slide;
  };
  const auto after = std::find_if(onset.begin() + 1, onset.end(),
                                  [&](const auto& instant) { return lag(instant) < 1e-3; });
  const auto before = after - 1;
  const double part =
      std::log(lag(*before) / 1e-3) / std::log(lag(*before) / std::max(lag(*after), 1e-9));
  const double begin = travel(*before);
  const double full_slip = begin + part * (travel(*after) - begin);
  return compare("M7", fmt::format("travel to full slip at mu = {} [um]", reference.friction),
                 full_slip * 1e6, reference.full_slip_travel * 1e6,
                 0.15 * reference.full_slip_travel * 1e6);
}

/// Relative difference between the sum of all friction tractions, as magnitudes, and mu times the
/// pressures. The cells slip in directions of their own.
double friction_excess(const ContactState& state, double friction) {
  double tangential = 0, normal = 0;
  for (std::size_t cell = 0; cell < state.normal_traction.size(); ++cell) {
    tangential += std::hypot(state.tangential_traction_x[cell], state.tangential_traction_y[cell]);
    normal += state.normal_traction[cell];
  }
  return std::abs(tangential / (friction * normal) - 1);
}

/// Adds the rows M4 and M5 over every stored state.
void add_condition_rows(const Case& input, double friction, const ContactSolution& solution,
                        std::vector<Row>& rows) {
  double full_slip = 0;
  const mechanics::StrainSource* source = nullptr;
  for (const auto* instant : touching(solution, 0, input.motion.cycle_duration())) {
    mechanics::core_strain(*instant->state); // which states its residual
    source = instant->state->source.get();
    const double since_slide = instant->time - input.motion.touchdown;
    if (since_slide > 0 && since_slide <= input.motion.slide && instant->state->stick_area == 0) {
      full_slip = std::max(full_slip, friction_excess(*instant->state, friction));
    }
  }
  const auto name = [&](const char* quantity) {
    return fmt::format("{} at mu = {}", quantity, friction);
  };
  rows.push_back(at_most("M4", name("|T / (mu N) - 1| in full slip"), full_slip, 1e-8));
  rows.push_back(at_most("M4", name("contact forces against those through levels of the core"),
                         source->worst_equilibrium_residual(), 5e-4));
  rows.push_back(at_most("M5", name("worst tension, penetration, cone or slip violation"),
                         solution.worst_complementarity_residual, 1e-8));
}

/// Relative difference of the tractions in two states.
double difference(const ContactState& one, const ContactState& other) {
  double largest = 0, scale = 0;
  for (std::size_t c = 0; c < one.normal_traction.size(); ++c) {
    scale = std::max(scale, one.normal_traction[c]);
    largest = std::max({largest, std::abs(one.normal_traction[c] - other.normal_traction[c]),
                        std::abs(one.tangential_traction_x[c] - other.tangential_traction_x[c]),
                        std::abs(one.tangential_traction_y[c] - other.tangential_traction_y[c])});
  }
  return scale > 0 ? largest / scale : 1;
}

/// Adds the row M8: a second touch on the skin as the first one left it, stepped in one path, which
/// must repeat the first.
void add_cycle_rows(const Case& cycle, const Options& options, std::vector<Row>& rows) {
  Case input = cycle;
  const std::vector<MotionLeg> legs = motion_legs(cycle.motion, cycle.slider);
  const double period = legs.back().end(), landed = cycle.motion.touchdown,
               slid = landed + cycle.motion.slide;
  const std::array<std::pair<const char*, std::vector<double>>, 3> phases{
      {{"second touch against first: tractions after touchdown", {landed}},
       {"second touch against first: tractions during onset and slide",
        {landed + 1e-3, landed + 3e-3, landed + 1e-2, (landed + slid) / 2, slid}},
       {"second touch against first: tractions during lift-off", {slid + 1e-4, slid + 3e-4}}}};
  input.motion.kind = MotionKind::waypoints;
  input.motion.waypoints = {{0, legs.front().from, legs.front().from_level.value, {}}};
  for (const double begin : {0.0, period}) {
    for (const MotionLeg& leg : legs) {
      input.motion.waypoints.push_back({begin + leg.end(), leg.to, leg.to_level.value, {}});
    }
    for (const auto& [quantity, instants] : phases) {
      for (const double instant : instants) {
        input.output.fields.push_back(begin + instant);
      }
    }
  }
  mechanics::ContactOptions contact;
  contact.threads = options.threads;
  base::Timers timers;
  const ContactSolution both = mechanics::solve_contact(input, contact, timers);
  for (const auto& [quantity, instants] : phases) {
    double largest = 0;
    for (const double instant : instants) {
      const auto &first = nearest(both, instant), &second = nearest(both, period + instant);
      largest = std::max(
          largest, first.state && second.state ? difference(*first.state, *second.state) : 1.0);
    }
    rows.push_back(at_most("M8", quantity, largest, 1e-8));
  }
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
  base::Timers timers;
  const auto solutions = mechanics::solve_contact(input, frictions, contact, timers);

  std::vector<Row> rows;
  for (std::size_t i = 0; i < solutions.size(); ++i) {
    add_condition_rows(input, frictions[i], solutions[i], rows);
    add_baseline_rows(input, references[i], solutions[i], rows);
    rows.push_back(full_slip_row(input, references[i], solutions[i]));
  }
  add_cycle_rows(input, options, rows);
  return rows;
}

} // namespace ionskin::verification
