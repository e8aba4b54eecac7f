// SPDX-License-Identifier: Apache-2.0
#include "electrochemistry/model_cases.hpp"
#include "electrochemistry/rows.hpp"

#include "ionskin/base/constants.hpp"
#include "ionskin/electrochemistry/grid/derived_scales.hpp"
#include "ionskin/electrochemistry/grid/transport_grid.hpp"
#include "ionskin/electrochemistry/ion_transport.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <span>
#include <string>

namespace ionskin::verification {
namespace {

using electrochemistry::IonSnapshot;
using electrochemistry::TransportGrid;

constexpr double debye_length = 20e-6, relaxation_time = 0.01;
constexpr double box_length = 300e-6, box_width = 200e-6, box_thickness = 180e-6;
constexpr double run_duration = 2.0 * relaxation_time;

/// An exact solution of the nonlinear equations under `pair-generation`, in Debye lengths and
/// relaxation times: phi = f(t) g(x, y, z) and a concentration c(phi) with
///   dc/dphi = -(c + f'/f) (1 - filling c),   c(0) = 1,
/// make the flux f' grad g, whose divergence is the rate of the charge, so that
/// cf = c + laplacian(phi) gives all else. g and its slope vanish on the electrodes, its normal
/// slope on the sides; f(0) = 0 starts it from the program's initial state.
class ExactSolution {
public:
  /// @param filling share of the sites that the ions at rest take; 0 for dilute ions
  explicit ExactSolution(double filling) : filling_(filling) {}

  struct Values {
    double potential, concentration, fixed_charge;
  };

  Values at(double time, double x, double y, double z) const {
    const double t = time / relaxation_time;
    const double rate = 0.5 * std::exp(-0.5 * t), f = 1.0 - std::exp(-0.5 * t);
    const double kx = std::numbers::pi / box_length, ky = std::numbers::pi / box_width;
    const double wave = std::cos(kx * x) * std::cos(ky * y), s = z / box_thickness;
    const double profile = s * s * (8.0 + s * s * (16.0 * s - 24.0));
    const double curvature = (16.0 + s * s * (320.0 * s - 288.0)) / (box_thickness * box_thickness);
    const double g = amplitude * (mean + wave) * profile;
    const double laplacian = amplitude * debye_length * debye_length *
                             ((mean + wave) * curvature - (kx * kx + ky * ky) * wave * profile);
    const double phi = f * g;
    const double c = f > 0.0 ? concentration(phi, rate / f) : initial_concentration(rate * g);
    return {phi, c, c + f * laplacian};
  }

private:
  static constexpr double amplitude = 0.7, mean = 0.4;

  /// @param growth f'/f
  double concentration(double phi, double growth) const {
    // (c + growth) / (1 - filling c), which is exponential in phi, less its value at c = 0
    const double full = 1.0 - filling_, power = -(1.0 + filling_ * growth) * phi;
    const double above =
        (std::exp(power) + growth * (std::expm1(power) + filling_)) / full; // no cancellation
    return above / (1.0 + filling_ * (above + growth));
  }
  /// Limit of the concentration for f = 0, where f'/f phi = `rise`.
  double initial_concentration(double rise) const {
    return filling_ > 0.0 ? (1.0 - (1.0 - filling_) * std::exp(filling_ * rise)) / filling_
                          : 1.0 - rise;
  }

  double filling_;
};

Case manufactured_case(double mesh_refinement, double filling) {
  Case input = model_case();
  input.skin.length = box_length;
  input.skin.width = box_width;
  auto& ions = input.electrochemistry;
  ions.permittivity = debye_length * debye_length * constants::faraday * constants::faraday *
                      ions.fixed_charge_concentration /
                      (constants::gas_constant * ions.temperature);
  ions.diffusivity = debye_length * debye_length / relaxation_time;
  if (filling > 0.0) {
    ions.ion_model = IonModel::steric;
    ions.largest_concentration = ions.fixed_charge_concentration / (filling * ions.valence);
  }
  input.coupling.law = "pair-generation";
  input.coupling.coefficient = 1.0;
  input.numerics.preset = Preset::fine;
  input.numerics.mesh_refinement = mesh_refinement;
  return input;
}

template <class Body> void for_nodes(const TransportGrid& grid, const Body& body) {
  for (const double z : grid.z_nodes) {
    for (std::size_t j = 0; j + 1 < grid.y_edges.size(); ++j) {
      for (std::size_t i = 0; i + 1 < grid.x_edges.size(); ++i) {
        body(0.5 * (grid.x_edges[i] + grid.x_edges[i + 1]),
             0.5 * (grid.y_edges[j] + grid.y_edges[j + 1]), z);
      }
    }
  }
}

/// Fixed charge of the exact solution, as a history of shear on the transport grid itself.
history::CoreHistory manufactured_history(const Case& input, const ExactSolution& exact,
                                          int samples) {
  history::CoreHistory history;
  history.measure = "manufactured";
  history.length = box_length;
  history.width = box_width;
  history.grid = {
      {0.0, 0.5 * box_length, box_length}, {0.0, 0.5 * box_width, box_width}, {0.0, box_thickness}};
  const TransportGrid grid = electrochemistry::make_transport_grid(input, history);
  history.grid = {grid.x_edges, grid.y_edges, grid.z_nodes};
  for (int sample = 0; sample <= samples; ++sample) {
    const double time = run_duration * sample / samples;
    auto field = std::make_shared<history::StrainField>();
    for_nodes(grid, [&](double x, double y, double z) {
      field->push_back(exact.at(time, x, y, z).fixed_charge - 1.0);
    });
    history.time.push_back(time);
    history.shear().push_back(field);
  }
  history.event_time = {0.0};
  return history;
}

struct FinalState {
  TransportGrid grid;
  /// Potential and concentration, in the units of the exact solution.
  std::vector<double> potential, concentration;
};

struct Steps {
  double refinement, tolerance;
  int samples; ///< number of samples of the history
};

FinalState run(double filling, double mesh_refinement, const Steps& steps, const Options& options) {
  Case input = manufactured_case(mesh_refinement, filling);
  input.numerics.time_refinement = steps.refinement;
  input.numerics.time_tolerance = steps.tolerance;
  electrochemistry::IonOptions ion_options;
  ion_options.threads = options.threads;
  ion_options.snapshot_times = {run_duration};
  base::Timers timers;
  const auto solution = electrochemistry::solve_ion_transport(
      input, manufactured_history(input, ExactSolution(filling), steps.samples), ion_options,
      timers);
  const auto scales = electrochemistry::derive_scales(input.electrochemistry, box_thickness);
  FinalState state{solution.grid, solution.snapshots.front().potential,
                   solution.snapshots.front().concentration};
  for (double& value : state.potential) {
    value /= scales.potential_scale;
  }
  for (double& value : state.concentration) {
    value /= input.electrochemistry.fixed_charge_concentration;
  }
  return state;
}

/// Root mean square of a difference over the nodes of all columns, weighted by the nodes' volumes.
double rms(const TransportGrid& grid, std::span<const double> a, std::span<const double> b) {
  const std::vector<double>& z = grid.z_nodes;
  const std::size_t columns = a.size() / z.size();
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const std::size_t k = i / columns;
    const double above = k + 1 < z.size() ? z[k + 1] : z[k], below = k > 0 ? z[k - 1] : z[k];
    sum += 0.5 * (above - below) * (a[i] - b[i]) * (a[i] - b[i]);
  }
  return std::sqrt(sum / (box_thickness * static_cast<double>(columns)));
}

struct Error {
  double potential, concentration;
};

Error error_of(const FinalState& state, const ExactSolution& exact) {
  std::vector<double> potential, concentration;
  for_nodes(state.grid, [&](double x, double y, double z) {
    const auto values = exact.at(run_duration, x, y, z);
    potential.push_back(values.potential);
    concentration.push_back(values.concentration);
  });
  return {rms(state.grid, state.potential, potential),
          rms(state.grid, state.concentration, concentration)};
}

double observed_order(double coarse, double fine) {
  return std::log2(coarse / fine);
}

/// Problem of one set of rows: its id, name, and share of sites that ions take.
struct Problem {
  std::string set, name;
  double filling; ///< share of the sites that ions at rest take; 0 for dilute ions
};

void add_space_rows(const Problem& problem, const Options& options, std::vector<Row>& rows) {
  // The samples are so many that linear interpolation between them does not count.
  constexpr Steps steps{1.0, 3e-6, 48};
  const auto error_at = [&](double refinement) {
    return error_of(run(problem.filling, refinement, steps, options),
                    ExactSolution(problem.filling));
  };
  const Error coarse = error_at(0.75), fine = error_at(1.5);
  const auto& [set, name, _] = problem;
  rows.push_back(at_most(set, name + ": error of phi / V_T, rms", fine.potential, 5e-4));
  rows.push_back(at_most(set, name + ": error of c / c0, rms", fine.concentration, 2e-4));
  rows.push_back(at_least(set, name + ": observed order of phi in space",
                          observed_order(coarse.potential, fine.potential), 1.95));
  rows.push_back(at_least(set, name + ": observed order of c in space",
                          observed_order(coarse.concentration, fine.concentration), 1.95));
}

/// Adds rows on the order in time, by differences between runs on one mesh, in which the error of
/// the mesh and the interpolation cancel.
void add_time_rows(const Problem& problem, const Options& options, std::vector<Row>& rows) {
  const auto at = [&](double refinement) {
    return run(problem.filling, 0.5, {refinement, 1e-3, 4}, options);
  };
  const FinalState first = at(4.0), second = at(8.0), third = at(16.0);
  const auto change = [&](const FinalState& a, const FinalState& b) {
    return Error{rms(first.grid, a.potential, b.potential),
                 rms(first.grid, a.concentration, b.concentration)};
  };
  const Error coarse = change(first, second), fine = change(second, third);
  const auto& [set, name, _] = problem;
  rows.push_back(at_least(set, name + ": observed order of phi in time",
                          observed_order(coarse.potential, fine.potential), 1.95));
  rows.push_back(at_least(set, name + ": observed order of c in time",
                          observed_order(coarse.concentration, fine.concentration), 1.95));
}

} // namespace

std::vector<Row> manufactured_rows(const Options& options) {
  std::vector<Row> rows;
  for (const Problem& problem : {Problem{"E7", "3D manufactured", 0.0},
                                 Problem{"E9", "3D manufactured, finite ions", 0.4}}) {
    add_space_rows(problem, options, rows);
    add_time_rows(problem, options, rows);
  }
  return rows;
}

} // namespace ionskin::verification
