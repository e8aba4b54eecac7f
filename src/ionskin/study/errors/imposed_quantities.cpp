// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/errors/imposed_quantities.hpp"

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
