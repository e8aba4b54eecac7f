// SPDX-License-Identifier: Apache-2.0
#include "ionskin/electrochemistry/thin_layers.hpp"

#include "ionskin/electrochemistry/grid/derived_scales.hpp"
#include "ionskin/poroelasticity/water_properties.hpp"
#include "model_cases.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

namespace ionskin::electrochemistry {
namespace {

constexpr double length = 0.4e-3; // of the skin [m]
constexpr std::size_t columns_along = 64;

/// Water that stays where it is, so that the drive is that of the undrained pressure.
Case still_case() {
  Case input = verification::model_case();
  input.skin.length = length;
  input.coupling = {};
  input.coupling.law = "poroelastic";
  input.skin.layers[1].material.poissons_ratio = 0.49999999;
  input.water.drag_number = 2.5;
  input.water.drained_modulus = 3.9e8;
  input.water.mobility = 1e-40;
  input.electrochemistry.ion_model = IonModel::thin_layers;
  return input;
}

/// A pressure [Pa] of the place along x [m] and of the height over the thickness, held from the
/// first instant.
history::CoreHistory held(const std::function<double(double, double)>& pressure, double end) {
  const Case input = still_case();
  history::CoreHistory history;
  history.grid = {{}, {0.0, input.skin.width}, {}};
  for (std::size_t i = 0; i <= columns_along; ++i) {
    history.grid.x_edges.push_back(length * static_cast<double>(i) / columns_along);
  }
  history.measure = "prescribed";
  history.length = length;
  history.width = input.skin.width;
  history.time = {0.0, end};
  history.event_time = {0.0};
  constexpr std::size_t intervals = 8;
  history::StrainField field;
  for (std::size_t k = 0; k <= intervals; ++k) {
    const double height = static_cast<double>(k) / intervals;
    history.grid.z_nodes.push_back(height * input.skin.core_thickness());
    for (std::size_t i = 0; i < columns_along; ++i) {
      const double place = 0.5 * (history.grid.x_edges[i] + history.grid.x_edges[i + 1]);
      field.push_back(pressure(place, height));
    }
  }
  history.add_channel(history::channel_name::undrained_pressure, "Pa")
      .samples.assign(2, std::make_shared<const history::StrainField>(field));
  return history;
}

IonSolution solve_layers(const Case& input, const history::CoreHistory& history) {
  return solve_thin_layers(input, history, {});
}

struct Scales {
  double layer, relaxation, volts; ///< eps/lambda [F/m2], sigma lambda/eps [m/s], L_s [V/Pa]
};

Scales scales_of(const Case& input) {
  const DerivedScales scales = derive_scales(input.electrochemistry, input.skin.core_thickness());
  const double layer = input.electrochemistry.permittivity / scales.debye_length;
  return {layer, scales.conductivity / layer,
          poroelasticity::derive_water_properties(input).streaming_coefficient};
}

/// Amplitude of a cosine of one half wave along the skin in the charge of the top wall [C/m2].
double amplitude(const IonSolution& solution, double width) {
  double sum = 0;
  const auto& edges = solution.grid.x_edges;
  for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
    const double place = 0.5 * (edges[i] + edges[i + 1]);
    sum += 2 * std::cos(std::numbers::pi * place / length) * solution.column_charge_top[i];
  }
  return sum / (length * width);
}

TEST(ThinLayers, OddAndEvenWavesRelaxAtTheirRates) {
  const Case input = still_case();
  const Scales scales = scales_of(input);
  const double wave = std::numbers::pi / length, half = 0.5 * input.skin.core_thickness();
  constexpr double pressure = 1e4;
  for (const bool odd : {true, false}) {
    const double rate =
        scales.relaxation * wave * (odd ? 1 / std::tanh(wave * half) : std::tanh(wave * half));
    const auto load = [&](double x, double height) {
      return pressure * std::cos(wave * x) * (odd ? 2 * height - 1 : 1.0);
    };
    const IonSolution solution = solve_layers(input, held(load, 1.0 / rate));
    const double expected = scales.layer * scales.volts * pressure * (1 - std::exp(-1.0));
    EXPECT_NEAR(amplitude(solution, input.skin.width), expected, 2e-3 * expected) << odd;
  }
}

TEST(ThinLayers, EvenPressureGivesNothingAndOpposedWallsTheCircuit) {
  const Case input = still_case();
  const IonSolution even = solve_layers(input, held([](double, double) { return 1e5; }, 1.0));
  const IonSolution odd =
      solve_layers(input, held([](double, double height) { return 1e5 * (height - 0.5); }, 1.0));
  const Scales scales = scales_of(input);
  const double area = length * input.skin.width;
  const double settled = 0.5 * scales.layer * area * scales.volts * 1e5;
  EXPECT_LT(std::abs(even.charge_top.back()), 1e-12 * settled);
  const double tau = input.skin.core_thickness() / (2 * scales.relaxation);
  EXPECT_NEAR(odd.charge_top.back(), settled * (1 - std::exp(-1.0 / tau)), 1e-9 * settled);
  EXPECT_DOUBLE_EQ(odd.charge_bottom.back(), -odd.charge_top.back());
}

TEST(ThinLayers, AMirroredLoadChangesTheSign) {
  const auto load = [](double x, double height) {
    return 1e4 * std::cos(3e4 * x) * (1 + 0.7 * height);
  };
  const auto mirrored = [&](double x, double height) { return load(x, 1 - height); };
  const IonSolution one = solve_layers(still_case(), held(load, 0.3));
  const IonSolution other = solve_layers(still_case(), held(mirrored, 0.3));
  EXPECT_NEAR(one.charge_top.back(), other.charge_bottom.back(),
              1e-10 * std::abs(one.charge_top.back()));
}

TEST(ThinLayers, TaxelsAddUpToTheElectrode) {
  Case input = still_case();
  input.readout.taxels = {{"left", {0.0, 0.0}, {0.15e-3, input.skin.width}},
                          {"right", {0.15e-3, 0.0}, {length, input.skin.width}}};
  const IonSolution solution = solve_layers(
      input, held([](double x, double height) { return 1e8 * x * (height - 0.3); }, 0.3));
  double sum = 0;
  for (const SegmentCharge& segment : solution.top_segments) {
    sum += segment.charge.back();
  }
  EXPECT_NEAR(sum, solution.charge_top.back(), 1e-12 * std::abs(sum));
  EXPECT_NE(solution.top_segments.front().charge.back(), 0);
}

TEST(ThinLayers, AnOpenCircuitShowsTheStreamingVoltage) {
  Case input = still_case();
  input.readout.circuit = "open";
  const IonSolution solution =
      solve_layers(input, held([](double, double height) { return 1e5 * height; }, 0.3));
  EXPECT_NEAR(solution.voltage.back(), -1e5 * scales_of(input).volts, 1e-9);
  EXPECT_EQ(solution.relaxation_charge.back(), 0);
}

} // namespace
} // namespace ionskin::electrochemistry
