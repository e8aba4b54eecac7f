// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/ion_error_estimate.hpp"

#include "ionskin/electrochemistry/ion_transport.hpp"
#include "ionskin/readout/metrics.hpp"
#include "ionskin/readout/sampling.hpp"
#include "ionskin/readout/signal_table.hpp"
#include "ionskin/readout/tail_current.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace ionskin::study {
namespace {

using electrochemistry::IonSolution;

/// Quantities below this share of the largest of their unit are rounding.
constexpr double rounding = 1e-9;

Case companion_of(const Case& input) {
  Case companion = input;
  companion.numerics.mesh_refinement *= 0.5;
  companion.numerics.time_refinement *= 0.5;
  return companion;
}

struct Currents {
  readout::SignalTable resolved, sampled;
  std::vector<readout::Metric> metrics;
};

Currents currents_of(const Case& input, const IonSolution& ions) {
  readout::SignalInputs inputs;
  inputs.time = ions.time;
  inputs.charge_top = ions.charge_top;
  inputs.charge_bottom = ions.charge_bottom;
  inputs.mean_shear.assign(ions.time.size(), std::numeric_limits<double>::quiet_NaN());
  inputs.rms_shear = inputs.p99_shear = inputs.shear_first_moment = inputs.mean_shear;
  Currents currents;
  currents.resolved = readout::build_signal_table(inputs);
  currents.sampled = readout::sample_currents(currents.resolved, input.readout.sample_interval,
                                              {ions.relaxation_charge, ions.relaxation_current});
  for (const auto& metric :
       readout::signal_metrics(currents.resolved, currents.sampled, std::nullopt)) {
    if (metric.name.find("current") != std::string::npos) {
      currents.metrics.push_back(metric);
    }
  }
  if (input.readout.circuit == ReadoutCircuit::open ||
      input.readout.circuit == ReadoutCircuit::load) {
    currents.metrics.push_back({"peak_voltage", readout::peak_magnitude(ions.voltage), "V"});
    currents.metrics.push_back({"rms_voltage", readout::rms_linear(ions.time, ions.voltage), "V"});
  }
  return currents;
}

/// Rms of the difference of the sampled difference currents outside the contact spikes, over the
/// rms of the finer one.
double tail_difference(const Currents& fine, const Currents& coarse,
                       const std::vector<bool>& tail) {
  const auto& values = fine.sampled.column("current_difference").values;
  const auto& others = coarse.sampled.column("current_difference").values;
  std::vector<double> differences;
  for (std::size_t i = 0; i < values.size(); ++i) {
    differences.push_back(values[i] - others[i]);
  }
  return readout::tail_rms(differences, tail) / readout::tail_rms(values, tail);
}

} // namespace

std::map<std::string, double> estimate_ion_errors(const Case& input,
                                                  const strain::StrainHistory& history,
                                                  const IonSolution& ions, int threads,
                                                  base::Timers& timers) {
  const base::Timers::Scope timer(timers, "error estimate");
  electrochemistry::IonOptions options;
  options.threads = threads;
  base::Timers companion_timers;
  const IonSolution companion = electrochemistry::solve_ion_transport(companion_of(input), history,
                                                                      options, companion_timers);
  const Currents fine = currents_of(input, ions), coarse = currents_of(input, companion);
  std::map<std::string, double> largest, errors;
  for (const auto& metric : fine.metrics) {
    largest[metric.unit] = std::max(largest[metric.unit], metric.value);
  }
  for (std::size_t i = 0; i < fine.metrics.size(); ++i) {
    const auto& [name, value, unit] = fine.metrics[i];
    if (value > rounding * largest[unit]) {
      errors[name] = std::abs(coarse.metrics[i].value - value) / value;
    }
  }
  const std::vector<bool> tail =
      readout::in_tail(fine.sampled, input.readout.sample_interval, history.event_time);
  if (errors.contains("rms_current_difference")) {
    errors["tail_current_difference"] = tail_difference(fine, coarse, tail);
  }
  return errors;
}

} // namespace ionskin::study
