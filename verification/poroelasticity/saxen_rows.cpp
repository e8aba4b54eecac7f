// SPDX-License-Identifier: Apache-2.0
#include "electrochemistry/linear_cell.hpp"
#include "electrochemistry/model_run.hpp"
#include "ionskin/base/constants.hpp"
#include "ionskin/electrochemistry/grid/derived_scales.hpp"
#include "ionskin/poroelasticity/water_properties.hpp"
#include "poroelasticity/rows.hpp"
#include "poroelasticity/wet_cell.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <fmt/format.h>
#include <string>
#include <utility>
#include <vector>

namespace ionskin::verification {
namespace {

using electrochemistry::ElectrodePotentials;
using electrochemistry::IonSolution;
using Complex = std::complex<double>;

constexpr double small_voltage = 1e-4; // [V], for a linear response

/// The cell in the Laplace domain after a step of the top electrode's potential by `small_voltage`:
/// linear Poisson-Nernst-Planck equations, and the water that its current drags. With y from the
/// middle of the core, c - c0/v = A sinh(q y), and the pressure is a multiple of sinh(q y) and one
/// of sinh(r y), r^2 = s/c_v.
class ChargedCell {
public:
  explicit ChargedCell(const Case& input)
      : ions_(electrochemistry::derive_scales(input.electrochemistry, input.skin.core_thickness())),
        water_(poroelasticity::derive_water_properties(input)),
        diffusivity_(input.electrochemistry.diffusivity), half_(0.5 * input.skin.core_thickness()),
        concentration_(input.electrochemistry.resting_concentration()),
        volume_(input.water.drag_number * constants::molar_volume_of_water) {}

  /// Volume of water through the top wall per area, both walls open [m s].
  Complex moved(Complex s) const {
    const auto [q, r] = waves(s);
    return volume_ * amplitude(s, q) *
           (moment(q) -
            spread(s, q) * (moment(q) - std::tanh(q * half_) / std::tanh(r * half_) * moment(r)));
  }

  /// Pressure of the top wall minus that of the bottom wall, both sealed [Pa s].
  Complex pressure(Complex s) const {
    const auto [q, r] = waves(s);
    const double modulus = water_.consolidation_coefficient / water_.mobility;
    return 2.0 * modulus * volume_ * amplitude(s, q) * spread(s, q) *
           (std::tanh(q * half_) - q / r * std::tanh(r * half_));
  }

private:
  std::array<Complex, 2> waves(Complex s) const {
    return {std::sqrt(s / diffusivity_ + 1.0 / (ions_.debye_length * ions_.debye_length)),
            std::sqrt(s / water_.consolidation_coefficient)};
  }
  /// Amplitude A cosh(q h/2) of the concentration.
  Complex amplitude(Complex s, Complex q) const {
    const Complex wall = ions_.debye_length * q;
    return -0.5 * small_voltage / s * concentration_ / ions_.potential_scale /
           (std::tanh(q * half_) / (wall * wall) + s * half_ / (diffusivity_ * q));
  }
  Complex spread(Complex s, Complex q) const {
    return s / (s - water_.consolidation_coefficient * q * q);
  }
  /// Moment of sinh(q y) about the middle over the thickness, over cosh(q h/2).
  Complex moment(Complex q) const { return (half_ / q - std::tanh(q * half_) / (q * q)) / half_; }

  electrochemistry::DerivedScales ions_;
  poroelasticity::WaterProperties water_;
  double diffusivity_, half_, concentration_, volume_;
};

Case between(Case input, WaterWall walls) {
  input.water.bottom_wall = input.water.top_wall = walls;
  return input;
}

/// Solves a cell without a load, in which the potential of the top electrode drives the current.
IonSolution driven(const Case& input, const ElectrodePotentials& potentials,
                   std::vector<double> instants, const Options& options) {
  electrochemistry::IonOptions ion_options;
  ion_options.threads = options.threads;
  ion_options.progress = options.progress;
  ion_options.potentials = potentials;
  base::Timers timers;
  return electrochemistry::solve_ion_transport(
      input, pressure_step_history(0.0, 0.0, std::move(instants)), ion_options, timers);
}

ElectrodePotentials step() {
  ElectrodePotentials potentials;
  potentials.top = [](double) { return small_voltage; };
  return potentials;
}

/// Potentials of a ramp by `small_voltage` a second, which gives a steady current once the double
/// layers follow.
ElectrodePotentials ramp() {
  ElectrodePotentials potentials;
  potentials.top = [](double time) { return small_voltage * time; };
  return potentials;
}

double moved(const IonSolution& solution, double time) {
  return solution.water.dragged_top[row_at(solution, time)] / electrode_area;
}

/// Minus the voltage of the open cell over the pressure between its walls before water moves
/// [V/Pa].
double streaming_potential(Case input, const Options& options) {
  input.water.mobility = 1e-40;
  input.readout.circuit = "open";
  return -run_model(input,
                    pressure_step_history(-0.5 * small_pressure, 0.5 * small_pressure, {0.0, 1.0}),
                    options)
              .voltage.back() /
         small_pressure;
}

void add_settled_rows(const Case& input, const std::string& name, const Options& options,
                      std::vector<Row>& rows) {
  const auto water = poroelasticity::derive_water_properties(input);
  const double settled = 20 * water.consolidation_time(input.skin.core_thickness());
  const IonSolution solution =
      driven(between(input, WaterWall::open), step(), {0.0, settled}, options);
  const double charge = charge_difference(solution, solution.time.size() - 1) / electrode_area;
  const double per_charge = -moved(solution, settled) / charge;
  const double expected = water.streaming_coefficient * layer_factor(input);
  rows.push_back(compare("P9", "water through open walls over the charge passed [m3/C], " + name,
                         per_charge, expected, 2e-3 * expected));
  rows.push_back(compare("P9", "the same over the streaming potential per pressure, " + name,
                         per_charge / streaming_potential(input, options), 1.0, 2e-3));
  rows.push_back(compare(
      "P9", "water through the bottom wall over that through the top one, " + name,
      solution.water.dragged_bottom.back() / solution.water.dragged_top.back(), -1.0, 1e-9));
}

/// Adds rows on the time in which the double layers charge.
void add_transient_rows(const Case& input, const std::string& name, const Options& options,
                        std::vector<Row>& rows) {
  const ChargedCell cell(input);
  const double slow =
      electrochemistry::derive_scales(input.electrochemistry, input.skin.core_thickness())
          .slow_time;
  const std::vector<double> instants{0.0, 0.3 * slow, slow, 3 * slow};
  const IonSolution open = driven(between(input, WaterWall::open), step(), instants, options);
  const IonSolution sealed = driven(input, step(), instants, options);
  for (const double time : {slow, 3 * slow}) {
    const double volume = inverse_laplace([&](Complex s) { return cell.moved(s); }, time);
    rows.push_back(
        compare("P9", fmt::format("water through an open wall at t = {:.4g} s [m], {}", time, name),
                moved(open, time), volume, 2e-3 * std::abs(volume)));
    const double pressure = inverse_laplace([&](Complex s) { return cell.pressure(s); }, time);
    rows.push_back(compare(
        "P9",
        fmt::format("pressure of it between sealed walls at t = {:.4g} s [Pa], {}", time, name),
        sealed.water.dragged_difference[row_at(sealed, time)], pressure,
        5e-3 * std::abs(pressure)));
  }
}

/// Adds rows on a steady current: volume flux over current, and the pressure that stops the water.
void add_steady_rows(const Options& options, std::vector<Row>& rows) {
  const Case input = proton_case();
  const auto water = poroelasticity::derive_water_properties(input);
  const double begin = 20 * water.consolidation_time(input.skin.core_thickness()),
               end = 1.2 * begin;
  const IonSolution open =
      driven(between(input, WaterWall::open), ramp(), {0.0, begin, end}, options);
  const double charge =
      (charge_difference(open, row_at(open, end)) - charge_difference(open, row_at(open, begin))) /
      electrode_area;
  const double expected = water.streaming_coefficient * layer_factor(input);
  rows.push_back(compare("P9", "flux of water over a steady current, walls open [m3/C]",
                         (moved(open, begin) - moved(open, end)) / charge, expected,
                         2e-3 * expected));
  const IonSolution sealed = driven(input, ramp(), {0.0, begin, end}, options);
  const double counter = expected * input.skin.core_thickness() / water.mobility;
  rows.push_back(compare("P9", "counter-pressure of a steady current, walls sealed [Pa m2/A]",
                         -sealed.water.dragged_difference.back() * (end - begin) / charge, counter,
                         2e-3 * counter));
}

double observed_order(const Options& options) {
  const double time = 0.849317;
  std::array<double, 3> volume{};
  for (std::size_t i = 0; i < volume.size(); ++i) {
    Case input = between(wet_case(), WaterWall::open);
    input.numerics.mesh_refinement = std::array{1.5, 3.0, 6.0}[i];
    input.numerics.time_refinement = 4;
    volume[i] = moved(driven(input, step(), {0.0, time}, options), time);
  }
  return std::log2(std::abs(volume[0] - volume[1]) / std::abs(volume[1] - volume[2]));
}

} // namespace

std::vector<Row> saxen_rows(const Options& options) {
  std::vector<Row> rows;
  for (const auto& [name, input] : {std::pair{std::string("slow water"), wet_case()},
                                    {std::string("wet protons"), proton_case()}}) {
    add_settled_rows(input, name, options, rows);
    add_transient_rows(input, name, options, rows);
  }
  add_steady_rows(options, rows);
  rows.push_back(
      at_least("P9", "observed order of the moved water in space", observed_order(options), 1.8));
  return rows;
}

} // namespace ionskin::verification
