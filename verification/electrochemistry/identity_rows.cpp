// SPDX-License-Identifier: Apache-2.0
#include "electrochemistry/model_cases.hpp"
#include "electrochemistry/model_run.hpp"
#include "electrochemistry/rows.hpp"
#include "ionskin/base/constants.hpp"
#include "ionskin/base/largest.hpp"
#include "ionskin/history/shear_statistics.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ionskin::verification {
namespace {

using electrochemistry::IonSolution;

/// Charge F c0 k integral(gamma) at each instant of a solution, with the integral of the strain
/// history itself [C].
std::vector<double> strain_charge(const Case& input, const history::CoreHistory& history,
                                  const IonSolution& solution) {
  std::vector<double> charge;
  for (const double time : solution.time) {
    charge.push_back(constants::faraday * input.electrochemistry.fixed_charge_concentration *
                     input.coupling.coefficient * history::shear_integral(history, time));
  }
  return charge;
}

/// Largest |Q_top + Q_bottom - expected| over the run, over the largest charge that the strain
/// makes.
double gauss_error(const IonSolution& solution, const std::vector<double>& charge, bool neutral) {
  double error = 0.0;
  for (std::size_t i = 0; i < charge.size(); ++i) {
    const double expected = neutral ? 0.0 : charge[i];
    error =
        std::max(error, std::abs(solution.charge_top[i] + solution.charge_bottom[i] - expected));
  }
  return error / base::largest_magnitude(charge);
}

double ramo_error(const IonSolution& solution) {
  double error = 0.0;
  for (std::size_t i = 0; i < solution.time.size(); ++i) {
    error = std::max(error, std::abs(solution.charge_top[i] - solution.ramo_charge_top[i]));
  }
  return error / base::largest_magnitude(solution.charge_top);
}

/// Largest |amount of ions - initial amount - released ions|, relative to the initial amount.
double ion_drift(const IonSolution& solution, const std::vector<double>& released_charge) {
  const double initial = solution.ion_amount.front();
  double error = 0.0;
  for (std::size_t i = 0; i < released_charge.size(); ++i) {
    const double released = released_charge[i] / constants::faraday;
    error = std::max(error, std::abs((solution.ion_amount[i] - released) / initial - 1.0));
  }
  return error;
}

/// Largest change of a charge between neighbouring rows [C]; exactly 0 where no current flows.
double largest_change(const std::vector<double>& charge) {
  double result = 0.0;
  for (std::size_t i = 1; i < charge.size(); ++i) {
    result = std::max(result, std::abs(charge[i] - charge[i - 1]));
  }
  return result;
}

std::vector<Row> uniform_shear_rows(const Options& options) {
  const IonSolution solution =
      run_model(model_case(), linear_step_history(1e-3, 1e-3, {0.0, 4.0}), options);
  const double unit = 1.0 / electrode_area;
  double difference = 0.0;
  for (std::size_t i = 0; i < solution.time.size(); ++i) {
    difference = std::max(difference, std::abs(charge_difference(solution, i)));
  }
  return {
      compare("E1", "uniform shear: charge of both electrodes at t = 0+ [C/m2]",
              unit * (solution.charge_top.front() + solution.charge_bottom.front()), 2.08408, 1e-5),
      compare("E1", "uniform shear: charge of the top electrode at t = 4 s [C/m2]",
              unit * solution.charge_top.back(), 1.04204, 1e-5),
      at_most("E1", "uniform shear: largest difference charge [C/m2]", unit * difference, 1e-10)};
}

std::vector<Row> sliding_rows(const std::string& law, const Options& options) {
  Case input = model_case();
  input.numerics.preset = Preset::coarse;
  input.numerics.mesh_refinement = 0.5; // identities hold on any mesh
  input.coupling.law = law;
  const history::CoreHistory history = sliding_contact_history(2);
  const IonSolution solution = run_model(input, history, options);
  const std::vector<double> charge = strain_charge(input, history, solution);
  const double lowest = *std::ranges::min_element(solution.min_concentration) /
                        input.electrochemistry.fixed_charge_concentration;
  const bool releases = law == "pair-generation";
  const std::vector<double> released = releases ? charge : std::vector(charge.size(), 0.0);
  return {
      at_most("E1", law + ": Gauss identity, two sliding cycles in 3D",
              gauss_error(solution, charge, law != "fixed-charge"), 1e-10),
      at_most("E2", law + ": Ramo identity", ramo_error(solution), 1e-10),
      at_most("E6", law + ": drift of the amount of ions", ion_drift(solution, released), 1e-12),
      at_least("E6", law + ": smallest concentration over c0", lowest, 1e-6)};
}

/// Rows on 100 cycles on the coarsest possible mesh, over which rounding errors must not
/// accumulate.
std::vector<Row> hundred_cycles_rows(const Options& options) {
  Case input = model_case();
  input.numerics.preset = Preset::coarse;
  input.numerics.mesh_refinement = 0.5;
  const history::CoreHistory history = sliding_contact_history(100);
  const IonSolution solution = run_model(input, history, options);
  const std::vector<double> charge = strain_charge(input, history, solution);
  return {
      at_most("E6", "drift of the amount of ions over 100 cycles",
              ion_drift(solution, std::vector(charge.size(), 0.0)), 1e-12),
      at_most("E1", "Gauss identity over 100 cycles", gauss_error(solution, charge, false), 1e-10)};
}

Row zero_coupling_row(const Options& options) {
  Case input = model_case();
  input.numerics.preset = Preset::coarse;
  input.coupling.coefficient = 0.0;
  const IonSolution solution = run_model(input, sliding_contact_history(1), options);
  return at_most(
      "C1", "largest change of charge without coupling [C]",
      std::max(largest_change(solution.charge_top), largest_change(solution.charge_bottom)), 0.0);
}

} // namespace

std::vector<Row> identity_rows(const Options& options) {
  std::vector<Row> rows = uniform_shear_rows(options);
  for (const char* law : {"fixed-charge", "volume-neutral", "column-neutral", "pair-generation"}) {
    const std::vector<Row> more = sliding_rows(law, options);
    rows.insert(rows.end(), more.begin(), more.end());
  }
  const std::vector<Row> cycles = hundred_cycles_rows(options);
  rows.insert(rows.end(), cycles.begin(), cycles.end());
  rows.push_back(zero_coupling_row(options));
  return rows;
}

} // namespace ionskin::verification
