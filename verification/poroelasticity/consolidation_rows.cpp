// SPDX-License-Identifier: Apache-2.0
#include "ionskin/poroelasticity/pore_pressure.hpp"
#include "poroelasticity/layer_after.hpp"
#include "poroelasticity/rows.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <utility>

namespace ionskin::verification {
namespace {

using poroelasticity::PorePressure;

constexpr std::size_t usual_elements = 12; // as many as a run has

double degree_of_consolidation(double time) {
  const Layer layer{usual_elements, {poroelasticity::sealed_wall, poroelasticity::open_wall}};
  return 1.0 - layer.integral(layer.after_step([](double) { return 1.0; }, time));
}

/// Pressure difference between sealed walls after p_u = z - 1/2, by its Fourier series.
double expected_difference(double time) {
  constexpr double pi = 3.14159265358979323846;
  double sum = 0;
  for (int n = 1; n < 400; n += 2) {
    sum += 8.0 / (pi * pi * n * n) * std::exp(-n * n * pi * pi * time);
  }
  return sum;
}

/// Sealed core of 6 x 4 columns under a load that moves and is then held.
struct SealedCore {
  std::size_t columns = 24;
  std::vector<double> lengths =
      poroelasticity::node_lengths(poroelasticity::wall_clustered_nodes(1.0, usual_elements));
  PorePressure water{{6, 4},
                     {0.5, 0.5},
                     poroelasticity::wall_clustered_nodes(1.0, usual_elements),
                     {poroelasticity::sealed_wall, poroelasticity::sealed_wall},
                     1.0};
  poroelasticity::PressureState state;
  std::vector<double> undrained, pressure;

  SealedCore() : undrained(water.values(), 0.0) { water.start(undrained, state); }

  void load(int instant) {
    for (std::size_t i = 0; i < undrained.size(); ++i) {
      undrained[i] = std::sin(0.7 * instant + 1.3 * static_cast<double>(i * i % 97));
    }
  }
  void step(double seconds) {
    poroelasticity::PressureState end;
    water.step(state, seconds, undrained, end);
    state = std::move(end);
    water.pressure(state, pressure);
  }
  /// Integral of `of(node)` over the core, per area of a column.
  template <class Of> double integral(const Of& of) const {
    double sum = 0;
    for (std::size_t i = 0; i < pressure.size(); ++i) {
      sum += lengths[i / columns] * of(i);
    }
    return sum;
  }
};

/// Largest change of the amount of water in the core, over the amount that the load would move.
double lost_water() {
  SealedCore core;
  double worst = 0;
  for (int instant = 1; instant <= 40; ++instant) {
    core.load(instant);
    core.step(0.01 * instant);
    const double moved = core.integral([&](std::size_t i) { return std::abs(core.undrained[i]); });
    const double left =
        core.integral([&](std::size_t i) { return core.pressure[i] - core.undrained[i]; });
    worst = std::max(worst, std::abs(left) / moved);
  }
  return worst;
}

/// Largest growth in one step of the integral of P^2, which flow under a held load only lowers,
/// over its first value.
double gained_energy() {
  SealedCore core;
  core.load(1);
  core.step(0.01);
  const auto energy = [&] {
    return core.integral([&](std::size_t i) { return core.pressure[i] * core.pressure[i]; });
  };
  const double first = energy();
  double last = first, worst = -1;
  for (int instant = 0; instant < 40; ++instant) {
    core.step(2e-3);
    worst = std::max(worst, (energy() - last) / first);
    last = energy();
  }
  return worst;
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
    const auto pressure = Layer{}.after_step([](double z) { return z - 0.5; }, time);
    rows.push_back(compare(
        "P2", fmt::format("pressure difference of sealed walls at c_v t/h2 = {}, relative", time),
        pressure.back() - pressure.front(), expected_difference(time), 1e-4));
  }
  rows.push_back(
      at_most("P7", "change of the water in a sealed core, relative", lost_water(), 1e-12));
  rows.push_back(at_most("P7", "energy that flowing water gains under a held load, relative",
                         gained_energy(), 0.0));
  return rows;
}

} // namespace ionskin::verification
