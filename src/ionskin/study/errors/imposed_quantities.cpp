// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/errors/imposed_quantities.hpp"

#include "ionskin/base/value_at.hpp"
#include "ionskin/laws/friction/friction_law.hpp"
#include "ionskin/mechanics/output/contact_solution.hpp"
#include "ionskin/readout/phases.hpp"
#include "ionskin/readout/slider_suffix.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <utility>

namespace ionskin::study {
namespace {

using readout::Metric;
using readout::MotionInstant;
using readout::Signal;

constexpr double solved_for = std::numeric_limits<double>::quiet_NaN();

/// Error of a normal force, where it is prescribed; NaN elsewhere [N].
double force_error(const MotionInstant& at, double force) {
  const bool given = at.level && at.level->is_force && at.level->touches() && force > 0;
  return given ? std::max(std::abs(force - at.level->value),
                          mechanics::contact_tolerance * at.level->value)
               : solved_for;
}

/// Error of the tangential force in mid-slide under a prescribed normal force, where the contact
/// slips as a whole and friction is a coefficient times the pressure in every direction: it is that
/// coefficient times the normal force, on any mesh. NaN elsewhere [N].
/// @param normal error of the normal force [N]
/// @param force, tangential normal and tangential force [N]
/// @param stuck share of the contact that sticks [1]
double sliding_error(const Contact& contact, double normal, double force, double tangential,
                     double stuck) {
  constexpr double rounding = 1e-9;
  const laws::Friction friction = laws::friction(contact.law, contact.friction, contact.parameters);
  const double limit = friction.limit({.normal_traction = 1}) * force,
               apart = std::abs(std::abs(tangential) - limit);
  const bool given = stuck == 0 && friction.across == 1 && laws::is_proportional(friction) &&
                     !laws::friction_law(contact.law).adheres && apart <= rounding * limit;
  return given ? std::max(apart, normal * limit / force) : solved_for;
}

double height_error(const MotionInstant& at, double height) {
  return at.level && !at.level->is_force ? std::abs(height - at.level->value) : solved_for;
}

/// Adds the errors of one slider.
/// @param input case with this slider only
/// @param suffix of the slider's signals and metrics
void add_slider(const Case& input, const std::string& suffix, const Signals& signals,
                ImposedErrors& errors) {
  const readout::MotionPhases phases(input.motion, input.slider);
  std::vector<MotionInstant> instants;
  for (const double time : signals.resolved.column("time").values) {
    instants.push_back(phases.at(time));
  }
  const auto add = [&](const std::string& name,
                       const std::function<double(const MotionInstant&, double)>& error) {
    const Signal& column = signals.resolved.column(name + suffix);
    Signal of{column.name, column.unit, {}};
    for (std::size_t row = 0; row < instants.size(); ++row) {
      of.values.push_back(error(instants[row], column.values[row]));
    }
    errors.signals.push_back(std::move(of));
  };
  add("normal_force", force_error);
  add("slider_z", height_error);
  const std::string guided = input.motion.drive.given() ? "drive_" : "slider_";
  for (const std::size_t d : {0, 1}) {
    add(guided + (d == 0 ? "x" : "y"),
        [d](const MotionInstant& at, double place) { return std::abs(place - at.centre[d]); });
  }
  for (const auto& [name, instant] :
       {std::pair{"normal_force_touchdown", readout::end_of_touchdown(input.motion, input.slider)},
        std::pair{"normal_force_slide", readout::middle_of_slide(input.motion, input.slider)}}) {
    const auto metric = std::ranges::find(signals.metrics, name + suffix, &Metric::name);
    if (metric != signals.metrics.end()) {
      const double error = force_error(phases.at(instant), metric->value);
      if (!std::isnan(error)) {
        errors.metrics.push_back({metric->name, error, metric->unit});
      }
    }
  }
  const auto normal =
      std::ranges::find(errors.metrics, "normal_force_slide" + suffix, &Metric::name);
  const auto tangential =
      std::ranges::find(signals.metrics, "tangential_force_slide" + suffix, &Metric::name);
  if (normal != errors.metrics.end() && tangential != signals.metrics.end()) {
    const auto force = std::ranges::find(signals.metrics, normal->name, &Metric::name);
    const double stuck = base::value_at(signals.resolved.column("time").values,
                                        signals.resolved.column("stick_share" + suffix).values,
                                        readout::middle_of_slide(input.motion, input.slider)),
                 error = sliding_error(input.contact, normal->value, force->value,
                                       tangential->value, stuck);
    if (!std::isnan(error)) {
      errors.metrics.push_back({tangential->name, error, tangential->unit});
    }
  }
}

} // namespace

ImposedErrors imposed_errors(const Case& input, const Signals& signals) {
  ImposedErrors errors;
  if (input.strain.kind == StrainSourceKind::contact) {
    const std::vector<Case> sliders = cases_of_sliders(input);
    for (std::size_t i = 0; i < sliders.size(); ++i) {
      add_slider(sliders[i], readout::slider_suffix(i), signals, errors);
    }
  }
  return errors;
}

} // namespace ionskin::study
