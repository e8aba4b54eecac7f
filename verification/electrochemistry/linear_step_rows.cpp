// SPDX-License-Identifier: Apache-2.0
#include "electrochemistry/model_cases.hpp"
#include "electrochemistry/model_run.hpp"
#include "electrochemistry/rows.hpp"

#include <array>
#include <cmath>
#include <fmt/format.h>

namespace ionskin::verification {
namespace {

using electrochemistry::IonSolution;

/// Difference charge over F c0 lambda, and current [A/m2], after a step S = 0.0015 y/a at t = 0:
/// inverse Laplace transform of the linearised equations, by modes and by Talbot's method, to all
/// digits shown.
struct Reference {
  double time, charge, current;
};
constexpr std::array<Reference, 5> references{{{1e-3, .06809872, -2.6106},
                                               {0.01, .06754910, -5.5422},
                                               {0.1, .06091059, -5.3709},
                                               {1.0, .02200196, -1.8541},
                                               {4.0, .00208097, -0.0535}}};
constexpr double amplitude = 0.0015, half_thickness = 136.244;

IonSolution run_step(double mesh_refinement, double time_refinement, const Options& options) {
  Case input = model_case();
  input.numerics.mesh_refinement = mesh_refinement;
  input.numerics.time_refinement = time_refinement;
  const double shear = amplitude / input.coupling.coefficient;
  // Steps land close to the references on either side, so that currents can be read there.
  std::vector<double> landings{0.0};
  for (const Reference& reference : references) {
    for (const double share : {0.9, 1.0, 1.1}) {
      landings.push_back(share * reference.time);
    }
  }
  return run_model(input, linear_step_history(-shear, shear, landings), options);
}

double charge(const IonSolution& solution, double time) {
  return charge_difference(solution, row_at(solution, time)) / (charge_density * electrode_area);
}

/// Derivative of the parabola through three rows [A/m2].
double current(const IonSolution& solution, double time) {
  const std::size_t row = row_at(solution, time);
  const auto slope = [&](std::size_t from) {
    return (charge_difference(solution, from + 1) - charge_difference(solution, from)) /
           (solution.time[from + 1] - solution.time[from]) / electrode_area;
  };
  const double before = solution.time[row] - solution.time[row - 1];
  const double after = solution.time[row + 1] - solution.time[row];
  return (slope(row - 1) * after + slope(row) * before) / (before + after);
}

/// Sum over the reference instants of the relative change of charge between two runs.
double change(const IonSolution& a, const IonSolution& b) {
  double sum = 0.0;
  for (const Reference& reference : references) {
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
  const double initial = amplitude * half_thickness / 3.0;
  std::vector<Row> rows{
      compare("E3", "charge / q0 at t = 0+", charge(standard, 0.0), initial, 1e-5 * initial)};
  for (const Reference& reference : references) {
    rows.push_back(compare("E3", fmt::format("charge / q0 at t = {} s", reference.time),
                           charge(standard, reference.time), reference.charge,
                           2e-3 * reference.charge));
    rows.push_back(compare("E3", fmt::format("current at t = {} s [A/m2]", reference.time),
                           current(standard, reference.time), reference.current,
                           0.01 * std::abs(reference.current)));
  }
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
