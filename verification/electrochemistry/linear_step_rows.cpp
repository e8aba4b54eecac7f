// SPDX-License-Identifier: Apache-2.0
#include "electrochemistry/linear_cell.hpp"
#include "electrochemistry/model_cases.hpp"
#include "electrochemistry/model_run.hpp"
#include "electrochemistry/rows.hpp"

#include <array>
#include <cmath>
#include <fmt/format.h>
#include <string>
#include <vector>

namespace ionskin::verification {
namespace {

using electrochemistry::IonSolution;

/// Reference value: an instant, and the difference charge over F c0 lambda after a step S = 0.0015
/// y/a at t = 0, to all digits shown (verification E3, computed by modes).
struct ChargeReference {
  double time, charge;
};
constexpr std::array<ChargeReference, 5> charge_references{
    {{1e-3, .06809872}, {0.01, .06754910}, {0.1, .06091059}, {1.0, .02200196}, {4.0, .00208097}}};
constexpr double half_thickness = 136.244;
/// Begin and end, over t, of the interval about an instant t over which currents are averaged.
constexpr double before = 0.95, after = 1.05;

Case step_case(Preset preset) {
  Case input = model_case();
  input.numerics.preset = preset;
  return input;
}

IonSolution run_step(const Case& input, const Options& options) {
  const double shear = step_amplitude / input.coupling.coefficient;
  std::vector<double> landings{0.0};
  for (const ChargeReference& reference : charge_references) {
    for (const double share : {before, 1.0, after}) {
      landings.push_back(share * reference.time);
    }
  }
  return run_model(input, linear_step_history(-shear, shear, landings), options);
}

IonSolution run_step(double mesh_refinement, double time_refinement, const Options& options) {
  Case input = step_case(Preset::standard);
  input.numerics.mesh_refinement = mesh_refinement;
  input.numerics.time_refinement = time_refinement;
  return run_step(input, options);
}

double charge(const IonSolution& solution, double time) {
  return charge_difference(solution, row_at(solution, time)) / (charge_density * electrode_area);
}

/// Mean current of a solution over the interval about an instant [A/m2].
double mean_current(const IonSolution& solution, double time) {
  const double gained = charge_difference(solution, row_at(solution, after * time)) -
                        charge_difference(solution, row_at(solution, before * time));
  return gained / ((after - before) * time * electrode_area);
}

/// Mean current over the interval about an instant by the closed form [A/m2].
double expected_current(const LinearCell& cell, double time) {
  const auto charge_at = [&](double instant) {
    return inverse_laplace([&](LinearCell::Complex s) { return cell.short_charge(s); }, instant);
  };
  return (charge_at(after * time) - charge_at(before * time)) / ((after - before) * time);
}

/// Adds rows that compare charges and currents with their references.
/// @param tolerance relative tolerance of charges and currents
void add_accuracy_rows(const IonSolution& solution, const std::string& preset, double tolerance,
                       std::vector<Row>& rows) {
  const LinearCell cell(model_case());
  for (const auto& [time, expected] : charge_references) {
    rows.push_back(compare("E3", fmt::format("charge / q0 at t = {} s, {}", time, preset),
                           charge(solution, time), expected, tolerance * expected));
    const double current = expected_current(cell, time);
    rows.push_back(compare("E3", fmt::format("current at t = {} s [A/m2], {}", time, preset),
                           mean_current(solution, time), current, tolerance * std::abs(current)));
  }
}

/// Sum over the reference instants of the relative change of charge between two runs.
double change(const IonSolution& a, const IonSolution& b) {
  double sum = 0.0;
  for (const ChargeReference& reference : charge_references) {
    sum += std::abs(charge(a, reference.time) - charge(b, reference.time)) / reference.charge;
  }
  return sum;
}

double observed_order(const IonSolution& coarse, const IonSolution& medium,
                      const IonSolution& fine) {
  return std::log2(change(coarse, medium) / change(medium, fine));
}

} // namespace

std::vector<Row> linear_step_rows(const Options& options) {
  const IonSolution standard = run_step(1.0, 1.0, options);
  const double initial = step_amplitude * half_thickness / 3.0;
  std::vector<Row> rows{
      compare("E3", "charge / q0 at t = 0+", charge(standard, 0.0), initial, 1e-5 * initial)};
  add_accuracy_rows(standard, "standard", 5e-3, rows);
  add_accuracy_rows(run_step(step_case(Preset::fine), options), "fine", 1e-3, rows);
  const std::array meshes{run_step(2.0, 1.0, options), run_step(4.0, 1.0, options),
                          run_step(8.0, 1.0, options)};
  rows.push_back(at_least("E3", "observed order of the charge in space",
                          observed_order(meshes[0], meshes[1], meshes[2]), 1.8));
  const std::array steps{run_step(1.0, 2.0, options), run_step(1.0, 4.0, options)};
  rows.push_back(at_least("E3", "observed order of the charge in time",
                          observed_order(standard, steps[0], steps[1]), 1.8));
  return rows;
}

} // namespace ionskin::verification
