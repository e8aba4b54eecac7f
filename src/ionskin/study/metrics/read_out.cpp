// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/metrics/read_out.hpp"

#include "ionskin/base/largest.hpp"
#include "ionskin/base/value_at.hpp"
#include "ionskin/case/coupling.hpp"
#include "ionskin/circuits/circuit.hpp"
#include "ionskin/electrochemistry/coupling/driving_channel.hpp"
#include "ionskin/electrochemistry/grid/derived_scales.hpp"
#include "ionskin/history/shear_statistics.hpp"
#include "ionskin/parallel/task_pool.hpp"
#include "ionskin/readout/circuit.hpp"
#include "ionskin/readout/phases.hpp"
#include "ionskin/readout/sampling.hpp"
#include "ionskin/readout/signal_table.hpp"
#include "ionskin/readout/slider_suffix.hpp"
#include "ionskin/readout/slip_onset.hpp"
#include "ionskin/readout/tail_current.hpp"
#include "ionskin/readout/taxels.hpp"
#include "ionskin/readout/water_signals.hpp"
#include "ionskin/study/metrics/reading_noise.hpp"
#include "ionskin/study/metrics/slip_metrics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace ionskin::study {
namespace {

using electrochemistry::IonSolution;

/// Replaces values between a sample without contact and the next one, which has contact, by the
/// value of the latter: the underside of a flat slider touches as a whole at once.
/// @param time, area of the samples [s], [m2]
/// @param samples of the quantity, linear in time between other samples
void touch_at_once(const std::vector<double>& time, const std::vector<double>& area,
                   const std::vector<double>& samples, const readout::SliderInputs& inputs,
                   const std::vector<double>& row_time, std::vector<double>& values) {
  for (std::size_t row = 0; row < values.size(); ++row) {
    const auto next =
        static_cast<std::size_t>(std::ranges::upper_bound(time, row_time[row]) - time.begin());
    if (next > 0 && next < time.size() && area[next - 1] == 0 && area[next] > 0 &&
        inputs.normal_force[row] > 0) {
      values[row] = samples[next];
    }
  }
}

/// Adds share and state of stick. Sticking and contact area are interpolated between the samples;
/// their ratio is not linear, and jumps where the slider lands.
template <class AtArea>
void add_stick(const SliderRecord& record, const AtArea& at_rows, readout::SliderInputs& inputs) {
  std::vector<double> stuck = record.stick_share;
  for (std::size_t i = 0; i < stuck.size(); ++i) {
    stuck[i] *= record.contact_area[i];
  }
  stuck = at_rows(stuck);
  for (std::size_t row = 0; row < stuck.size(); ++row) {
    const double area = inputs.contact_area[row], share = area > 0 ? stuck[row] / area : 0;
    inputs.stick_share.push_back(share);
    inputs.slip_state.push_back(static_cast<double>(readout::slip_state(area, share)));
  }
}

/// Adds the forces of a slider at the instants of the rows.
/// @param time of the samples [s]
template <class AtRows>
void add_forces(const Slider& slider, const std::vector<double>& time, const SliderRecord& record,
                const AtRows& at_rows, const std::vector<double>& row_time,
                readout::SliderInputs& inputs) {
  inputs.slider_z = at_rows(record.slider_z);
  inputs.normal_force = at_rows(record.normal_force);
  inputs.tangential_force = at_rows(record.tangential_force);
  inputs.tangential_force_x = at_rows(record.tangential_force_x);
  inputs.tangential_force_y = at_rows(record.tangential_force_y);
  inputs.moment_x = at_rows(record.moment_x);
  inputs.moment_y = at_rows(record.moment_y);
  inputs.moment_z = at_rows(record.moment_z);
  inputs.slip = at_rows(record.slip);
  const bool at_once = slider.sharp() && !slider.changing.any();
  const auto area_at_rows = [&](const std::vector<double>& samples) {
    std::vector<double> values = at_rows(samples);
    if (at_once) {
      touch_at_once(time, record.contact_area, samples, inputs, row_time, values);
    }
    return values;
  };
  inputs.contact_area = area_at_rows(record.contact_area);
  add_stick(record, area_at_rows, inputs);
}

/// Adds motion and forces of the sliders after the first.
template <class AtRows>
void add_further_sliders(const Case& input, const MechanicsRecord& mechanics, const AtRows& at_rows,
                         readout::SignalInputs& inputs) {
  for (std::size_t i = 0; i < mechanics.further_sliders.size(); ++i) {
    const FurtherSlider& further = input.further_sliders[i];
    readout::SignalInputs own;
    own.time = inputs.time;
    readout::add_motion(own, further.motion, further.slider);
    add_forces(further.slider, mechanics.history.time, mechanics.further_sliders[i], at_rows,
               inputs.time, own);
    inputs.further_sliders.push_back(std::move(own));
  }
}

/// Motion, forces and shear at the instants of the rows; the caller adds the charges.
readout::SignalInputs mechanical_inputs(const Case& input, const MechanicsRecord& mechanics,
                                        const std::vector<double>& time, int threads) {
  readout::SignalInputs inputs;
  inputs.time = time;
  if (mechanics.has_contact()) {
    readout::add_motion(inputs, input.motion, input.slider);
    const auto at_rows = [&](const std::vector<double>& samples) {
      std::vector<double> values;
      values.reserve(time.size());
      for (const double t : time) {
        values.push_back(base::value_at(mechanics.history.time, samples, t));
      }
      return values;
    };
    add_forces(input.slider, mechanics.history.time, mechanics, at_rows, time, inputs);
    add_further_sliders(input, mechanics, at_rows, inputs);
    if (!mechanics.drive_force_x.empty()) {
      // The motion of the case moves the end of the drive; the slider follows as it was solved.
      inputs.drive_x = std::move(inputs.slider_x);
      inputs.drive_y = std::move(inputs.slider_y);
      inputs.slider_x = at_rows(mechanics.history.slider_x);
      inputs.slider_y =
          mechanics.history.slider_y.empty() ? inputs.drive_y : at_rows(mechanics.history.slider_y);
      inputs.drive_force_x = at_rows(mechanics.drive_force_x);
      inputs.drive_force_y = at_rows(mechanics.drive_force_y);
    }
  } else {
    inputs.cycle.assign(time.size(), 1);
    inputs.phase.assign(time.size(), "");
  }
  std::vector<history::ShearStatistics> statistics(time.size());
  parallel::run_tasks(time.size(), threads, [&](std::size_t row) {
    statistics[row] = history::shear_statistics(mechanics.history, time[row]);
  });
  for (const auto& row : statistics) {
    inputs.mean_shear.push_back(row.mean);
    inputs.rms_shear.push_back(row.rms);
    inputs.p99_shear.push_back(row.p99);
    inputs.shear_first_moment.push_back(row.first_moment);
  }
  return inputs;
}

std::optional<readout::NamedInstants> named_instants(const Case& input,
                                                     const MechanicsRecord& mechanics) {
  if (!mechanics.has_contact()) {
    return std::nullopt;
  }
  return readout::NamedInstants{readout::end_of_touchdown(input.motion, input.slider),
                                readout::middle_of_slide(input.motion, input.slider)};
}

/// Adds the metrics of the sliders after the first, with their suffixes.
void add_further_metrics(const Case& input, const MechanicsRecord& mechanics,
                         const readout::SignalTable& signals,
                         std::vector<readout::Metric>& metrics) {
  for (std::size_t i = 0; i < mechanics.further_sliders.size(); ++i) {
    const FurtherSlider& further = input.further_sliders[i];
    const std::string suffix = readout::slider_suffix(i + 1);
    const auto at = [&](const std::string& name, double instant) {
      return base::value_at(signals.column("time").values, signals.column(name + suffix).values,
                            instant);
    };
    const double slide = readout::middle_of_slide(further.motion, further.slider);
    metrics.push_back(
        {"normal_force_touchdown" + suffix,
         at("normal_force", readout::end_of_touchdown(further.motion, further.slider)), "N"});
    metrics.push_back({"normal_force_slide" + suffix, at("normal_force", slide), "N"});
    metrics.push_back({"tangential_force_slide" + suffix, at("tangential_force", slide), "N"});
    for (const readout::Metric& metric : mechanics.further_sliders[i].metrics) {
      metrics.push_back({metric.name + suffix, metric.value, metric.unit});
    }
  }
}

/// Largest value of a residual over all sliders.
double worst_of_sliders(const MechanicsRecord& mechanics, double SliderRecord::*residual) {
  double worst = mechanics.*residual;
  for (const SliderRecord& further : mechanics.further_sliders) {
    worst = base::nan_max(worst, further.*residual);
  }
  return worst;
}

void add_slide_metrics(const Case& input, const MechanicsRecord& mechanics,
                       const readout::SignalTable& signals, std::vector<readout::Metric>& metrics) {
  if (!mechanics.has_contact()) {
    return;
  }
  const auto slide = history::shear_statistics(
      mechanics.history, readout::middle_of_slide(input.motion, input.slider));
  metrics.push_back({"p95_shear_slide", slide.p95, "1"});
  metrics.push_back({"element_max_shear_slide", slide.element_max, "1"});
  metrics.insert(metrics.end(), mechanics.metrics.begin(), mechanics.metrics.end());
  const auto slip = slip_metrics(input, mechanics);
  metrics.insert(metrics.end(), slip.begin(), slip.end());
  // Stresses of several sliders are not added up.
  if (!mechanics.electrode_stress.empty() && mechanics.further_sliders.empty()) {
    metrics.push_back(
        {"electrode_membrane_stress",
         *std::max_element(mechanics.electrode_stress.begin(), mechanics.electrode_stress.end()),
         "Pa"});
  }
  metrics.push_back({"equilibrium_residual",
                     worst_of_sliders(mechanics, &SliderRecord::worst_equilibrium_residual), "1"});
  metrics.push_back({"complementarity_residual",
                     worst_of_sliders(mechanics, &SliderRecord::worst_complementarity_residual),
                     "1"});
  // Always 0, as strain is not interpolated between positions of the slider; scripts still expect
  // the name.
  metrics.push_back({"interpolation_error", 0.0, "1"});
  add_further_metrics(input, mechanics, signals, metrics);
}

void add_tail_metric(const Case& input, const MechanicsRecord& mechanics, Signals& signals) {
  const std::vector<bool> tail = readout::in_tail(
      signals.sampled, input.readout.sample_interval, mechanics.history.event_time,
      electrochemistry::derive_scales(input.electrochemistry, mechanics.history.core_thickness())
          .relaxation_time);
  signals.metrics.push_back(
      {"tail_current_difference",
       readout::tail_rms(signals.sampled.column("current_difference").values, tail), "A"});
}

/// Metric of the violation of Gauss' law: charge of both electrodes against the integral of the
/// channel that drives the ions. Empty under a law whose net charge is not linear in this channel,
/// as the expected charge is not known then.
std::optional<readout::Metric> charge_identity(const Case& input, const MechanicsRecord& mechanics,
                                               const IonSolution& ions, int threads) {
  const laws::CouplingTraits traits = laws::coupling_law(input.coupling.law).traits;
  if (traits.makes_net_charge && !traits.net_charge_is_linear) {
    return std::nullopt;
  }
  const history::HistoryChannel& channel =
      electrochemistry::driving_channel(input.coupling.law, mechanics.history);
  const double factor = electrochemistry::charge_density_of_channel(input, channel);
  std::vector<double> expected(ions.time.size()), magnitude(ions.time.size());
  parallel::run_tasks(expected.size(), threads, [&](std::size_t row) {
    const history::ChannelIntegrals drive =
        history::channel_integrals(mechanics.history, channel, ions.time[row]);
    expected[row] = factor * drive.value;
    magnitude[row] = factor * drive.magnitude;
  });
  const double scale =
      readout::peak_magnitude(magnitude) + electrochemistry::charge_moved_by_outside_water(input);
  if (!traits.makes_net_charge) {
    expected.assign(expected.size(), 0.0);
  }
  return readout::Metric{
      "charge_identity_error",
      readout::charge_identity_error(ions.charge_top, ions.charge_bottom, expected, scale), "1"};
}

void add_ion_metrics(const Case& input, const IonSolution& ions,
                     const readout::SignalTable& signals, std::vector<readout::Metric>& metrics) {
  const double shear = readout::peak_magnitude(signals.column("p99_shear").values);
  const auto scales =
      electrochemistry::derive_scales(input.electrochemistry, input.skin.core_thickness());
  // A law that moves water has no coefficient k, and a value of 0 would say that it is linear.
  if (!moves_water(input)) {
    metrics.push_back({"nonlinearity",
                       electrochemistry::nonlinearity(scales, input.coupling.coefficient, shear),
                       "1"});
  }
  const double initial =
      input.electrochemistry.fixed_charge_concentration / input.electrochemistry.valence;
  metrics.push_back(
      {"min_concentration_ratio",
       *std::min_element(ions.min_concentration.begin(), ions.min_concentration.end()) / initial,
       "1"});
  metrics.push_back({"max_potential", readout::peak_magnitude(ions.max_potential), "V"});
}

/// Adds the reading of an instrument of the charge that its circuit has passed.
/// @param kind "Taxel" or "Line", for warnings
/// @param interval readout interval [s]
void add_reading_of(const circuits::Circuit& circuit, const std::string& kind,
                    const IonSolution& ions, const electrochemistry::SegmentCharge& segment,
                    double interval, Signals& signals) {
  const readout::SampledReading reading =
      readout::sampled_reading(circuit, ions.time, segment.passed, interval);
  readout::add_reading(segment.name, reading.at_rows.current, *signals.taxels);
  readout::add_reading(segment.name, reading.mean_current, *signals.sampled_taxels);
  for (const std::string& warning : reading.at_rows.warnings) {
    signals.warnings.push_back(fmt::format("{} {}: {}", kind, segment.name, warning));
  }
}

/// Adds the readings of the instruments of all taxels, or of all lines of a crossbar.
void add_readings(const Readout& readout, const IonSolution& ions, Signals& signals) {
  const std::vector<Taxel> lines = readout.lines();
  for (std::size_t e = 0; e < lines.size(); ++e) {
    const circuits::Circuit circuit = circuits::circuit(lines[e].circuit, readout.parameters);
    if (circuit.read) {
      add_reading_of(circuit, "Line", ions, ions.lines[e], readout.sample_interval, signals);
    }
  }
  if (readout.is_crossbar()) {
    return;
  }
  for (std::size_t i = 0; i < readout.taxels.size(); ++i) {
    const circuits::Circuit circuit =
        circuits::circuit(readout.circuit_of(i), readout.parameters_of(i));
    if (readout.has_own_circuit(i) && circuit.read) {
      add_reading_of(circuit, "Taxel", ions, ions.top_segments[i], readout.sample_interval,
                     signals);
    }
  }
}

/// Adds the readings of taxels with circuits of their own, their largest voltage, and the crosstalk
/// between them.
void add_circuits_of_taxels(const Readout& readout, const IonSolution& ions, Signals& signals) {
  if (!readout.is_cut()) {
    return;
  }
  add_readings(readout, ions, signals);
  signals.metrics.push_back(
      {"peak_taxel_voltage", readout::largest_of_taxels(*signals.taxels, "voltage_"), "V"});
  if (ions.taxel_crosstalk) {
    signals.metrics.push_back({"taxel_crosstalk", *ions.taxel_crosstalk, "1"});
  }
}

void add_taxels(const IonSolution& ions, bool moves_water, double interval, Signals& signals) {
  if (ions.top_segments.empty()) {
    return;
  }
  std::vector<readout::TaxelCharge> charges;
  for (const auto& segment : ions.top_segments) {
    charges.push_back({segment.name, segment.charge,
                       moves_water ? segment.bottom_charge : std::vector<double>{}, segment.voltage,
                       segment.passed});
  }
  std::vector<readout::TaxelCharge> lines;
  for (const auto& line : ions.lines) {
    lines.push_back({line.name, {}, {}, line.voltage, line.passed});
  }
  signals.taxels = readout::taxel_signals(ions.time, charges, lines);
  signals.sampled_taxels = readout::sample_table(*signals.taxels, interval);
  // Where no charge passes, there is nothing to balance: the electrode's charge is rounding then.
  if (readout::carry_current(*signals.taxels)) {
    signals.metrics.push_back({"taxel_balance_error",
                               readout::taxel_balance_error(
                                   *signals.taxels, signals.resolved.column("current_top").values),
                               "1"});
  }
}

/// Adds the signals and metrics of the water, and the charges at the end of the run and of the
/// first slide.
void add_water(const Case& input, const circuits::Circuit& circuit,
               const MechanicsRecord& mechanics, const IonSolution& ions, Signals& signals) {
  signals.water = readout::water_signals(
      {ions.time, ions.water.pressure_top, ions.water.pressure_bottom, ions.water.streaming_voltage,
       ions.water.dilution_voltage, ions.water.largest_pressure, ions.water.largest_drive,
       ions.water.outflow_top, ions.water.outflow_bottom, ions.water.dragged_top,
       ions.water.dragged_bottom, ions.water.dragged_difference, ions.water.holding_pressure});
  std::optional<double> force;
  if (mechanics.has_contact()) {
    force = readout::peak_magnitude(mechanics.normal_force);
  }
  const auto metrics =
      readout::water_metrics(*signals.water, force, input.skin.length * input.skin.width);
  signals.metrics.insert(signals.metrics.end(), metrics.begin(), metrics.end());
  if (circuit.admittance && !circuit.admittance->passes_charge()) {
    return;
  }
  const auto charge = readout::charge_difference(ions.charge_top, ions.charge_bottom);
  signals.metrics.push_back({"charge_difference_end", charge.back(), "C"});
  if (mechanics.has_contact()) {
    signals.metrics.push_back(
        {"charge_difference_slide_end",
         base::value_at(ions.time, charge, readout::end_of_slide(input.motion, input.slider)),
         "C"});
  }
}

void add_instrument(const circuits::Circuit& circuit, const IonSolution& ions, double interval,
                    Signals& signals) {
  const readout::SampledReading reading = readout::sampled_reading(
      circuit, ions.time, readout::charge_difference(ions.charge_top, ions.charge_bottom),
      interval);
  signals.circuit = readout::instrument_signals(ions.time, reading.at_rows);
  signals.sampled_circuit = readout::sampled_instrument_signals(ions.time, interval, reading);
  for (const circuits::InstrumentFigure& figure : reading.at_rows.figures) {
    signals.metrics.push_back({figure.name, figure.value, figure.unit});
  }
  signals.warnings.insert(signals.warnings.end(), reading.at_rows.warnings.begin(),
                          reading.at_rows.warnings.end());
}

void add_terminals(const IonSolution& ions, double interval, Signals& signals) {
  signals.circuit = readout::terminal_signals(
      ions.time, ions.voltage, readout::charge_difference(ions.charge_top, ions.charge_bottom));
  signals.sampled_circuit = readout::sample_table(*signals.circuit, interval);
  signals.metrics.push_back({"peak_voltage", readout::peak_magnitude(ions.voltage), "V"});
  signals.metrics.push_back({"rms_voltage", readout::rms_linear(ions.time, ions.voltage), "V"});
}

void add_circuit(const circuits::Circuit& circuit, const IonSolution& ions, double interval,
                 Signals& signals) {
  if (circuit.read) {
    add_instrument(circuit, ions, interval, signals);
  } else if (circuit.admittance) {
    add_terminals(ions, interval, signals);
  }
}

} // namespace

Signals read_out_rows(const Case& input, const MechanicsRecord& mechanics, const IonSolution& ions,
                      int threads) {
  auto inputs = mechanical_inputs(input, mechanics, ions.time, threads);
  inputs.charge_top = ions.charge_top;
  inputs.charge_bottom = ions.charge_bottom;
  Signals signals;
  signals.resolved = readout::build_signal_table(inputs);
  signals.sampled = readout::sample_currents(signals.resolved, input.readout.sample_interval,
                                             {ions.relaxation_charge, ions.relaxation_current});
  return signals;
}

Signals read_out(const Case& input, const MechanicsRecord& mechanics, const IonSolution& ions,
                 int threads) {
  Signals signals = read_out_rows(input, mechanics, ions, threads);
  signals.metrics =
      readout::signal_metrics(signals.resolved, signals.sampled, named_instants(input, mechanics));
  add_tail_metric(input, mechanics, signals);
  add_slide_metrics(input, mechanics, signals.resolved, signals.metrics);
  if (const auto identity = charge_identity(input, mechanics, ions, threads)) {
    signals.metrics.push_back(*identity);
  }
  add_ion_metrics(input, ions, signals.resolved, signals.metrics);
  const bool moves_water = ionskin::moves_water(input);
  const circuits::Circuit circuit =
      circuits::circuit(input.readout.circuit, input.readout.parameters);
  if (!ions.metal_drop.empty()) {
    signals.metrics.push_back({"peak_metal_drop", std::ranges::max(ions.metal_drop), "V"});
  }
  add_taxels(ions, moves_water, input.readout.sample_interval, signals);
  add_circuits_of_taxels(input.readout, ions, signals);
  if (moves_water) {
    add_water(input, circuit, mechanics, ions, signals);
  }
  if (!input.readout.is_cut()) {
    add_circuit(circuit, ions, input.readout.sample_interval, signals);
    add_noise(input, mechanics, ions, signals);
  }
  if (signals.taxels) {
    signals.metrics.push_back({"peak_sampled_taxel_current",
                               readout::largest_taxel_current(*signals.sampled_taxels), "A"});
    if (input.readout.is_cut()) {
      add_noise_of_taxel(input, mechanics, ions, signals);
    }
  }
  return signals;
}

Signals read_out_mechanics_rows(const Case& input, const MechanicsRecord& mechanics, int threads) {
  const auto& time = mechanics.history.time;
  auto inputs = mechanical_inputs(input, mechanics, time, threads);
  inputs.charge_top.assign(time.size(), std::numeric_limits<double>::quiet_NaN());
  inputs.charge_bottom = inputs.charge_top;
  Signals signals;
  signals.resolved = readout::build_signal_table(inputs);
  signals.sampled = readout::sample_currents(signals.resolved, input.readout.sample_interval);
  return signals;
}

Signals read_out_mechanics(const Case& input, const MechanicsRecord& mechanics, int threads) {
  Signals signals = read_out_mechanics_rows(input, mechanics, threads);
  for (const auto& metric : readout::signal_metrics(signals.resolved, signals.sampled,
                                                    named_instants(input, mechanics))) {
    if (metric.name.find("current") == std::string::npos &&
        metric.name.find("charge") == std::string::npos) {
      signals.metrics.push_back(metric);
    }
  }
  add_slide_metrics(input, mechanics, signals.resolved, signals.metrics);
  return signals;
}

std::vector<readout::Metric> audited_metrics(const MechanicsRecord& mechanics,
                                             const Signals& signals) {
  std::vector<readout::Metric> metrics = signals.metrics;
  if (mechanics.has_contact()) {
    double largest = 0;
    for (const double shear : signals.resolved.column("p99_shear").values) {
      largest = base::nan_max(largest, std::abs(shear));
    }
    metrics.push_back({"largest_p99_shear", largest, "1"});
  }
  return metrics;
}

} // namespace ionskin::study
