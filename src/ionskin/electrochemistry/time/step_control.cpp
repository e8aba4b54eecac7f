// SPDX-License-Identifier: Apache-2.0
#include "ionskin/electrochemistry/time/step_control.hpp"

#include "ionskin/base/error.hpp"

#include <algorithm>
#include <cmath>

namespace ionskin::electrochemistry {
namespace {

/// Factor of safety on the length at which the error would be just allowed.
constexpr double safety = 0.85;
constexpr double smallest_shrinkage = 0.1;

/// Number of values that factors on a length have per doubling. Late in a decay the error of a step
/// is little more than rounding, and lengths in proportion to it would depend on the processor.
constexpr double factors_per_doubling = 32;

/// Computes the factor on a step's length that brings its error, of third order, to the allowed
/// error, rounded.
double ideal_factor(double error) {
  if (std::isnan(error)) {
    return smallest_shrinkage;
  }
  const double factor = safety / std::cbrt(std::max(error, 1e-12));
  return std::exp2(std::round(factors_per_doubling * std::log2(factor)) / factors_per_doubling);
}

/// Limits on the longest step, which resolve the end of a decay, where the charge left is small
/// beside the charge that the error is measured against: a share of the time in which double layers
/// charge, 0.15 s in the baseline, or of the time since the decay began, whichever is longer.
/// Slower decays, by water or through a load, are thus resolved, too, and a fast decay does not
/// cost steps when it is over.
constexpr double longest_share = 0.15 / 0.8493165557971034, late_share = 0.05;

// Constants of the estimates of steps, see relaxation_step and crossing_step.
constexpr double error_constant = 0.0404, kink_constant = 0.055;

/// Largest number of steps that an estimate counts; far more than any run takes.
constexpr double most_steps = 1e12;

// Weights of the errors of single columns where they are to be resolved, and elsewhere.
constexpr double resolved_share = 0.01, overall_share = 0.001;

/// Largest ratio of a step to the one before it. After an event the first currents are small beside
/// the charge that the error is measured against, so that this ratio, not the error, resolves them.
double growth(Preset preset) {
  switch (preset) {
  case Preset::coarse:
    return 3.0;
  case Preset::standard:
    return 2.0;
  case Preset::fine:
    return 1.4;
  }
  throw InternalError("unknown preset");
}

} // namespace

double preset_tolerance(Preset preset) {
  switch (preset) {
  case Preset::coarse:
    return 3e-4;
  case Preset::standard:
    return 5e-5;
  case Preset::fine:
    return 1.5e-6;
  }
  throw InternalError("unknown preset");
}

StepRule step_rule(const Numerics& numerics, const Readout& readout, const DerivedScales& scales) {
  const double refinement = numerics.time_refinement;
  const double tolerance =
      numerics.time_tolerance > 0.0 ? numerics.time_tolerance : preset_tolerance(numerics.preset);
  return {tolerance / (refinement * refinement * refinement),
          std::min(1e-5, scales.slow_time / 1000.0) / refinement,
          longest_share * scales.slow_time / refinement,
          late_share / refinement,
          1e-9 * scales.relaxation_time,
          std::pow(growth(numerics.preset), 1.0 / refinement),
          readout.taxels.empty() ? overall_share : resolved_share};
}

StepControl::StepControl(StepLandings landings, const StepRule& rule)
    : landings_(std::move(landings)), rule_(rule) {
  double event = landings_.time.front();
  for (std::size_t i = 0; i < landings_.time.size(); ++i) {
    event = landings_.is_event[i] ? landings_.time[i] : event;
    event_.push_back(event);
  }
}

double StepControl::longest(double time) const {
  const double since_event = time - event_[landings_.behind(time) - 1];
  return std::max(rule_.longest, rule_.late_share * since_event);
}

bool StepControl::has_landed(const std::vector<double>& ends) const {
  if (ends.empty() || ends.front() != landings_.time.front()) {
    return false;
  }
  const auto passed =
      landings_.time.begin() + static_cast<std::ptrdiff_t>(landings_.behind(ends.back()));
  return std::includes(ends.begin(), ends.end(), landings_.time.begin(), passed);
}

double StepControl::step_end(double time, double wanted) const {
  const std::size_t next = landings_.behind(time);
  const double landing = landings_.time[next], rest = landing - time;
  // One step from landing to landing, whose error is likely to be just allowed, is cheaper than two
  // short steps.
  const double share = landings_.time[next - 1] == time ? 0.9 : 0.999;
  const double most = longest(time);
  if (std::min(wanted / share, most) >= rest) {
    return landing;
  }
  const double length = std::min(wanted, most);
  // Two equal steps are better than a long and a tiny one.
  return time + (2.0 * length > rest ? 0.5 * rest : length);
}

double StepControl::after_success(double begin, double end, double wanted, double error) const {
  const std::size_t landing = landings_.behind(end) - 1;
  if (landings_.time[landing] == end && landings_.is_event[landing]) {
    return rule_.first;
  }
  const double length = end - begin;
  const double next = length * std::clamp(ideal_factor(error), smallest_shrinkage, rule_.growth);
  // A step cut short by a landing says little about a longer one.
  return next >= length ? std::max(next, std::min(wanted, longest(begin))) : next;
}

double StepControl::after_rejection(double begin, double end, double error) const {
  return (end - begin) * std::clamp(ideal_factor(error), smallest_shrinkage, 0.7);
}

double StepControl::column_share(double begin) const {
  return landings_.is_field[landings_.behind(begin)] ? resolved_share : rule_.column_share;
}

double relaxation_step(const StepRule& rule, const DerivedScales& scales) {
  return safety * scales.slow_time * std::cbrt(rule.tolerance / error_constant);
}

double crossing_step(const StepRule& rule, double crossing_time) {
  return safety * crossing_time * std::sqrt(rule.tolerance / (kink_constant * rule.column_share));
}

std::size_t estimate_steps(const StepLandings& landings, const StepRule& rule, double relaxing,
                           const std::vector<double>& longest) {
  const double early = std::min(rule.longest, relaxing),
               late = early / rule.late_share; // since the event, from when on steps lengthen
  double steps = 0, step = rule.first, event = landings.time.front();
  for (std::size_t i = 1; i < landings.time.size(); ++i) {
    const double end = landings.time[i] - event;
    double since = landings.time[i - 1] - event; // the event [s]
    while (since < end) {
      const double most = std::min(std::max(early, rule.late_share * since), longest[i - 1]),
                   length = std::min(step, most);
      step = length * rule.growth;
      if (length < most || (most < longest[i - 1] && since >= late)) {
        since += length;
        ++steps;
      } else { // steps of one length, however many
        const double until = most < longest[i - 1] ? std::min(end, late) : end;
        steps += std::ceil((until - since) / most * (1.0 - 1e-12));
        since = until;
      }
    }
    if (landings.is_event[i]) {
      step = rule.first;
      event = landings.time[i];
    }
  }
  return static_cast<std::size_t>(std::min(steps, most_steps));
}

} // namespace ionskin::electrochemistry
