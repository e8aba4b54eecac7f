// SPDX-License-Identifier: Apache-2.0
#include "electrochemistry/model_cases.hpp"
#include "electrochemistry/model_run.hpp"
#include "electrochemistry/rows.hpp"
#include "ionskin/electrochemistry/small_signal.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <fmt/format.h>

namespace ionskin::verification {
namespace {

using electrochemistry::IonSolution;

Case steric_case(double filling, Preset preset = Preset::standard) {
  Case input = model_case();
  input.numerics.preset = preset;
  input.electrochemistry.ion_model = IonModel::steric;
  input.electrochemistry.largest_concentration =
      input.electrochemistry.fixed_charge_concentration / filling;
  return input;
}

/// Charge over F c0 lambda of a double layer that is `potential` [R T/F] above the core, for ions
/// that fill a share b of their sites at rest. In equilibrium c/(1 - b c) exp(phi) is the same
/// everywhere, so that c = 1/(b + (1 - b) exp(phi)), and the first integral of phi'' = 1 - c is
///   sigma^2 / 2 = integral from 0 to `potential` of (1 - c) dphi,
/// here by Gauss's rule with three points on 4000 intervals.
double layer_charge(double potential, double filling) {
  constexpr int intervals = 4000;
  const double node = std::sqrt(0.6);
  const double half = 0.5 * potential / intervals;
  double integral = 0.0;
  const auto excess = [filling](double phi) {
    return 1.0 - 1.0 / (filling + (1.0 - filling) * std::exp(phi));
  };
  for (int i = 0; i < intervals; ++i) {
    const double middle = (2 * i + 1) * half;
    integral += half *
                (5.0 * excess(middle - node * half) + 8.0 * excess(middle) +
                 5.0 * excess(middle + node * half)) /
                9.0;
  }
  return std::copysign(std::sqrt(2.0 * integral), potential);
}

/// Charge of such a double layer in closed form, docs/model.md (16): sigma^2 / 2 = psi + ln(1 - b +
/// b exp(-psi)) / b.
double closed_layer_charge(double potential, double filling) {
  const double square = potential + std::log1p(filling * std::expm1(-potential)) / filling;
  return std::copysign(std::sqrt(2.0 * square), potential);
}

/// Charge of both double layers of a core of many Debye lengths under `voltage`, which they share
/// so that their charges are equal and opposite.
double cell_charge(double voltage, double filling) {
  double low = 0.0, high = voltage;
  for (int i = 0; i < 60; ++i) {
    const double top = 0.5 * (low + high);
    (layer_charge(top, filling) + layer_charge(top - voltage, filling) < 0.0 ? low : high) = top;
  }
  return layer_charge(low, filling);
}

/// Charge of the top electrode over F c0 lambda after a ramp to `voltage` thermal voltages within
/// 0.5 s and a rest of many charging times.
double settled_charge(const Case& input, double voltage, const Options& options) {
  electrochemistry::IonOptions ion_options;
  ion_options.threads = options.threads;
  const electrochemistry::DerivedScales scales =
      electrochemistry::derive_scales(input.electrochemistry, input.skin.core_thickness());
  const double potential = voltage * scales.thermal_voltage;
  ion_options.potentials.top = [potential](double time) {
    return potential * std::min(1.0, time / 0.5);
  };
  base::Timers timers;
  const IonSolution solution = electrochemistry::solve_ion_transport(
      input, linear_step_history(0.0, 0.0, {0.0, 0.5, 40.0}), ion_options, timers);
  return solution.charge_top.back() / (scales.charge_density * electrode_area);
}

/// Adds rows on the observed orders at a small voltage; at larger voltages errors of either sign
/// cancel on affordable meshes.
void add_order_rows(double filling, const Options& options, std::vector<Row>& rows) {
  constexpr double voltage = 1.0;
  double coarser = 0.0;
  for (const double refinement : {1.0, 2.0, 4.0, 8.0}) {
    Case input = steric_case(filling, Preset::coarse);
    input.numerics.mesh_refinement = refinement;
    input.numerics.time_tolerance = 1e-6; // Newton's method leaves a share of it
    const double error =
        std::abs(settled_charge(input, voltage, options) - cell_charge(voltage, filling));
    if (refinement > 1.0) {
      rows.push_back(compare(
          "E9",
          fmt::format("observed order of the wall charge in space, mesh_refinement {}", refinement),
          std::log2(coarser / error), 2.0, 0.25));
    }
    coarser = error;
  }
}

void add_steric_layer_rows(const Options& options, std::vector<Row>& rows) {
  constexpr double crowded = 0.5;
  rows.push_back(compare("E9", "layer of 20 thermal voltages: closed form against quadrature",
                         closed_layer_charge(-20.0, crowded), layer_charge(-20.0, crowded), 1e-9));
  for (const auto& [filling, voltage] :
       {std::pair{0.1, 5.0}, std::pair{0.5, 1.0}, std::pair{0.5, 5.0}, std::pair{0.5, 20.0}}) {
    const double charge = cell_charge(voltage, filling);
    rows.push_back(compare("E9",
                           fmt::format("wall charge / q0 at {} thermal voltages, c_max = {:.3g} c0",
                                       voltage, 1 / filling),
                           settled_charge(steric_case(filling), voltage, options), charge,
                           2e-3 * charge));
  }
  add_order_rows(crowded, options, rows);
}

/// Case of dilute ions with the small signals of a steric case: with the thermodynamic factor f =
/// 1/(1 - c0/c_max) it has f times the diffusivity and, as for the electrodes' charges at one
/// potential, f times the permittivity.
Case equivalent_dilute_case(const Case& steric) {
  Case input = steric;
  const double factor = 1.0 / (1.0 - input.electrochemistry.resting_concentration() /
                                         input.electrochemistry.largest_concentration);
  input.electrochemistry.diffusivity *= factor;
  input.electrochemistry.permittivity *= factor;
  input.electrochemistry.ion_model = IonModel::dilute;
  return input;
}

/// Largest difference between the top charges of two runs with the same samples, relative.
double largest_deviation(const Case& a, const Case& b, const history::CoreHistory& history,
                         const Options& options) {
  const IonSolution one = run_model(a, history, options), other = run_model(b, history, options);
  double error = 0.0, scale = 0.0;
  for (const double time : history.time) {
    const double expected = charge_difference(other, row_at(other, time));
    error = std::max(error, std::abs(charge_difference(one, row_at(one, time)) - expected));
    scale = std::max(scale, std::abs(expected));
  }
  return error / scale;
}

/// Error of the steric cell's impedance, against dilute ions with f times the diffusivity and
/// permittivity, whose potentials are 1/f of those of the steric cell.
double impedance_error() {
  const Case input = steric_case(0.5, Preset::fine);
  const Case dilute = equivalent_dilute_case(input);
  const double factor = dilute.electrochemistry.diffusivity / input.electrochemistry.diffusivity;
  const electrochemistry::SmallSignalCell cell(input), reference(dilute);
  double worst = 0.0;
  for (int i = 0; i <= 25; ++i) {
    const double frequency = 0.01 * std::pow(10.0, 0.2 * i);
    const std::complex<double> expected = factor * reference.area_impedance(frequency);
    worst = std::max(worst, std::abs(cell.area_impedance(frequency) / expected - 1.0));
  }
  return worst;
}

void add_steric_limit_rows(const Options& options, std::vector<Row>& rows) {
  rows.push_back(at_most("E9", "relative error of Z, 0.01 Hz to 1 kHz, fine, c_max = 2 c0",
                         impedance_error(), 1e-3));
  Case linear = steric_case(0.5, Preset::coarse);
  linear.numerics.mesh_refinement = 0.5; // both runs of a comparison have one mesh
  linear.coupling.coefficient = 1e-4;
  const history::CoreHistory history = sliding_contact_history(1);
  rows.push_back(
      at_most("E9", "sliding in 3D at k = 0.0001: deviation from the equivalent dilute ions",
              largest_deviation(linear, equivalent_dilute_case(linear), history, options), 1e-2));
  Case roomy = steric_case(1e-9, Preset::coarse);
  roomy.numerics.mesh_refinement = 0.5;
  // Steps that only landings, growth and the longest step set are the same in both runs.
  roomy.numerics.time_tolerance = 1.0;
  Case dilute = roomy;
  dilute.electrochemistry.ion_model = IonModel::dilute;
  rows.push_back(at_most("E9", "sliding in 3D, c_max = 1e9 c0: deviation from dilute ions",
                         largest_deviation(roomy, dilute, history, options), 1e-6));
}

void add_crowded_sliding_rows(const Options& options, std::vector<Row>& rows) {
  for (const char* law : {"fixed-charge", "pair-generation"}) {
    Case input = steric_case(0.7, Preset::coarse);
    input.numerics.mesh_refinement = 0.5; // what must hold holds on any mesh
    input.coupling.law = law;
    input.coupling.coefficient = 1.0;
    const IonSolution solution = run_model(input, sliding_contact_history(1), options);
    double ramo = 0.0, scale = 0.0;
    for (std::size_t i = 0; i < solution.time.size(); ++i) {
      ramo = std::max(ramo, std::abs(solution.charge_top[i] - solution.ramo_charge_top[i]));
      scale = std::max(scale, std::abs(solution.charge_top[i]));
    }
    rows.push_back(at_most("E9", fmt::format("{}, k = 1, c_max = 1.43 c0: Ramo identity", law),
                           ramo / scale, 1e-10));
    if (std::string_view(law) == "fixed-charge") {
      const auto [least, most] = std::ranges::minmax(solution.ion_amount);
      rows.push_back(at_most("E9",
                             "fixed-charge, k = 1, c_max = 1.43 c0: drift of the amount of ions",
                             most / least - 1.0, 1e-12));
    }
  }
}

} // namespace

std::vector<Row> steric_rows(const Options& options) {
  std::vector<Row> rows;
  add_steric_layer_rows(options, rows);
  add_steric_limit_rows(options, rows);
  add_crowded_sliding_rows(options, rows);
  return rows;
}

} // namespace ionskin::verification
