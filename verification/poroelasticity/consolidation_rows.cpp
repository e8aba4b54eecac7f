// SPDX-License-Identifier: Apache-2.0
#include "ionskin/poroelasticity/pore_pressure.hpp"
#include "poroelasticity/rows.hpp"

#include <array>
#include <cmath>
#include <fmt/format.h>
#include <utility>

namespace ionskin::verification {
namespace {

using poroelasticity::PorePressure;

constexpr std::size_t elements = 12; // as many as a run has

/// P through a layer of unit thickness and consolidation coefficient, a time after a step of p_u.
template <class Load>
std::vector<double> after_step(const std::array<WaterWall, 2>& walls, const Load& load,
                               double time) {
  PorePressure water({1, 1}, {1.0, 1.0}, poroelasticity::wall_clustered_nodes(1.0, elements), walls,
                     1.0);
  std::vector<double> undrained, pressure;
  for (const double z : water.nodes()) {
    undrained.push_back(load(z));
  }
  poroelasticity::PressureState begin, end;
  water.start(undrained, begin);
  water.step(begin, time, undrained, end);
  water.pressure(end, pressure);
  return pressure;
}

double degree_of_consolidation(double time) {
  const auto pressure = after_step(
      {WaterWall::sealed, WaterWall::open}, [](double) { return 1.0; }, time);
  const auto lengths =
      poroelasticity::node_lengths(poroelasticity::wall_clustered_nodes(1.0, elements));
  double mean = 0;
  for (std::size_t i = 0; i < pressure.size(); ++i) {
    mean += lengths[i] * pressure[i];
  }
  return 1.0 - mean;
}

/// Of p_u = z - 1/2 between sealed walls, by its Fourier series.
double expected_difference(double time) {
  constexpr double pi = 3.14159265358979323846;
  double sum = 0;
  for (int n = 1; n < 400; n += 2) {
    sum += 8.0 / (pi * pi * n * n) * std::exp(-n * n * pi * pi * time);
  }
  return sum;
}

} // namespace

std::vector<Row> consolidation_rows() {
  std::vector<Row> rows;
  for (const auto& [time, degree] : {std::pair{0.19673074, 0.5}, {0.84808541, 0.9}}) {
    rows.push_back(compare("P1",
                           fmt::format("Terzaghi's degree of consolidation at c_v t/h2 = {}", time),
                           degree_of_consolidation(time), degree, 1e-4));
  }
  for (const double time : {0.01, 0.1, 0.3, 1.0}) {
    const auto pressure = after_step(
        {WaterWall::sealed, WaterWall::sealed}, [](double z) { return z - 0.5; }, time);
    rows.push_back(compare(
        "P2", fmt::format("pressure difference of sealed walls at c_v t/h2 = {}, relative", time),
        pressure.back() - pressure.front(), expected_difference(time), 1e-4));
  }
  return rows;
}

} // namespace ionskin::verification
