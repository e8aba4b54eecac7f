// SPDX-License-Identifier: Apache-2.0
#include "electrochemistry/model_run.hpp"
#include "ionskin/poroelasticity/prescribed_load.hpp"
#include "ionskin/poroelasticity/water_properties.hpp"
#include "poroelasticity/layer_after.hpp"
#include "poroelasticity/rows.hpp"
#include "poroelasticity/wet_cell.hpp"

#include <boost/math/tools/roots.hpp>
#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <numbers>

namespace ionskin::verification {
namespace {

using poroelasticity::open_wall;
using poroelasticity::sealed_wall;
using std::numbers::pi;

constexpr int terms = 400;

/// Water that has left a layer through its open face, over the thickness, since a unit of pressure
/// stands at the other face; with the time lag of Daynes 1920, doi 10.1098/rspa.1920.0034.
double permeated(double time) {
  double sum = time - 1.0 / 6;
  for (int n = 1; n < terms; ++n) {
    sum += (n % 2 == 0 ? -2 : 2) / (pi * pi * n * n) * std::exp(-n * n * pi * pi * time);
  }
  return sum;
}

/// Permeated amount by finite elements: the steady flow less the amount that the layer has stored.
double permeated(std::size_t elements, double time) {
  const Layer layer{elements, {open_wall, open_wall}};
  std::vector<double> taken = layer.after_step([](double z) { return z - 1; }, time);
  const auto nodes = poroelasticity::wall_clustered_nodes(1.0, elements);
  for (std::size_t i = 0; i < taken.size(); ++i) {
    taken[i] = (taken[i] + 1 - nodes[i]) * nodes[i];
  }
  return time - layer.integral(taken);
}

/// Root of a function between two points at which its sign differs.
template <class Function> double root(const Function& function, double from, double to) {
  std::uintmax_t steps = 200;
  const auto [low, high] = boost::math::tools::toms748_solve(
      function, from, to, boost::math::tools::eps_tolerance<double>(50), steps);
  return 0.5 * (low + high);
}

/// Mean pressure left in a layer that is sealed at one face and exchanges water at the other by a
/// finite conductance (Carslaw and Jaeger, Conduction of Heat in Solids, 1959, section 3.11).
double left_by_exchange(double exchange, double time) {
  double sum = 0;
  for (int n = 0; n < terms; ++n) {
    const double wave = root([&](double x) { return x * std::sin(x) - exchange * std::cos(x); },
                             n * pi + 1e-12, (n + 0.5) * pi);
    sum += 4 * std::pow(std::sin(wave), 2) / (wave * (2 * wave + std::sin(2 * wave))) *
           std::exp(-wave * wave * time);
  }
  return sum;
}

double left_by_exchange(std::size_t elements, double exchange, double time) {
  const Layer layer{elements, {sealed_wall, exchange}};
  return layer.integral(layer.after_step([](double) { return 1.0; }, time));
}

/// Mean pressure of a layer that is held compressed, sealed at one face and open at the other, over
/// the pressure M d/h, by the poles of docs/model.md (75) after Laplace.
/// @param stiffness M/M_B
double left_under_compression(double stiffness, double time) {
  double sum = 0;
  for (int n = 1; n < terms; ++n) {
    const double wave = root([&](double x) { return std::sin(x) + stiffness * x * std::cos(x); },
                             (n - 0.5) * pi, n * pi);
    sum += 2 * (1 + stiffness) / (1 + stiffness + std::pow(stiffness * wave, 2)) *
           std::exp(-wave * wave * time);
  }
  return sum;
}

double left_under_compression(std::size_t elements, double stiffness, double time) {
  const double share = 1 / (1 + stiffness);
  const Layer layer{elements, {sealed_wall, open_wall}, share};
  return layer.integral(layer.after_step([&](double) { return share; }, time));
}

/// Case of the permeation cell: water under pressure below, both walls open, open terminals.
Case permeation_cell() {
  Case input = wet_case();
  input.strain.kind = StrainSourceKind::prescribed;
  input.readout.circuit = "open";
  input.water.bottom_wall = input.water.top_wall = WaterWall::open;
  input.water.bottom_pressure = small_pressure;
  return input;
}

std::vector<Row> permeation_rows(const Options& options) {
  std::vector<Row> rows;
  for (const double time : {0.05, 0.2, 1.0}) {
    rows.push_back(compare(
        "P11", fmt::format("water through a layer under pressure at c_v t/h2 = {}, over h", time),
        permeated(12, time), permeated(time), 1e-5));
  }
  rows.push_back(at_least("P11", "observed order of it in the elements",
                          order_in_elements([](std::size_t elements) {
                            return permeated(elements, 0.1) - permeated(0.1);
                          }),
                          3.8));
  Case input = permeation_cell();
  const auto water = poroelasticity::derive_water_properties(input);
  const double thickness = input.skin.core_thickness();
  const double area = input.skin.length * input.skin.width;
  input.strain.duration = 2 * thickness * thickness / water.consolidation_coefficient;
  const auto solution = run_model(input, poroelasticity::prescribed_history(input), options);
  const double passed =
      area * water.mobility * small_pressure / thickness *
      (input.strain.duration - thickness * thickness / (6 * water.consolidation_coefficient));
  rows.push_back(compare("P11", "water through the top wall of a permeation cell [m3]",
                         solution.water.outflow_top.back(), passed, 1e-3 * passed));
  const double voltage = water.streaming_coefficient * small_pressure;
  rows.push_back(compare("P11", "its streaming potential [V]",
                         solution.water.streaming_voltage.back(), voltage, 1e-5 * voltage));
  return rows;
}

std::vector<Row> conductance_rows() {
  std::vector<Row> rows;
  for (const double exchange : {0.1, 1.0, 10.0}) {
    rows.push_back(
        compare("P12",
                fmt::format("mean pressure at c_v t/h2 = 0.2 behind a wall of conductance {} K/h",
                            exchange),
                left_by_exchange(12, exchange, 0.2), left_by_exchange(exchange, 0.2), 1e-5));
  }
  rows.push_back(at_least(
      "P12", "observed order of it in the elements", order_in_elements([](std::size_t elements) {
        return left_by_exchange(elements, 1.0, 0.2) - left_by_exchange(1.0, 0.2);
      }),
      3.8));
  const Layer tight{12, {sealed_wall, 1e-12}}, sealed{12, {sealed_wall, sealed_wall}};
  const Layer wide{12, {sealed_wall, 1e6}}, open{12, {sealed_wall, open_wall}};
  const auto difference = [](const Layer& one, const Layer& other) {
    const auto left = [](const Layer& layer) {
      return layer.integral(layer.after_step([](double) { return 1.0; }, 0.2));
    };
    return std::abs(left(one) - left(other));
  };
  rows.push_back(at_most("P12", "the same of a conductance of 1e-12 K/h, off a sealed wall",
                         difference(tight, sealed), 1e-10));
  rows.push_back(at_most("P12", "the same of a conductance of 1e6 K/h, off an open wall",
                         difference(wide, open), 1e-6));
  return rows;
}

std::vector<Row> compression_rows() {
  std::vector<Row> rows;
  for (const double stiffness : {0.1, 1.0, 10.0}) {
    rows.push_back(compare(
        "P13",
        fmt::format("mean pressure at c_v t/h2 = 0.1 of a held compression, M/M_B = {}", stiffness),
        left_under_compression(12, stiffness, 0.1), left_under_compression(stiffness, 0.1),
        1e-4 * left_under_compression(stiffness, 0.1)));
  }
  rows.push_back(at_least(
      "P13", "observed order of it in the elements", order_in_elements([](std::size_t elements) {
        return left_under_compression(elements, 1.0, 0.1) - left_under_compression(1.0, 0.1);
      }),
      3.8));
  return rows;
}

} // namespace

std::vector<Row> wall_rows(const Options& options) {
  std::vector<Row> rows = permeation_rows(options);
  for (const auto& more : {conductance_rows(), compression_rows()}) {
    rows.insert(rows.end(), more.begin(), more.end());
  }
  return rows;
}

} // namespace ionskin::verification
