// SPDX-License-Identifier: Apache-2.0
#include "ionskin/electrochemistry/circuit/layer_circuit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <utility>

namespace ionskin::electrochemistry {
namespace {

constexpr double capacitance = 2e-6, resistance = 5e4; // of the cell [F], [ohm]

LayerCircuit::State held(const LayerCircuit& circuit, double force, double duration, int steps) {
  LayerCircuit::State state = circuit.start(force);
  for (int i = 0; i < steps; ++i) {
    state = circuit.step(state, duration / steps, force, force);
  }
  return state;
}

TEST(LayerCircuit, AnAmountFollowsALinearSourceExactly) {
  // dx/dt = 3 (source - x), source = 2 + 5 t: x = 2 + 5 t - 5/3 + c exp(-3 t).
  const double start = 0.7, rate = 3, t = 0.4;
  const double constant = start - (2 - 5.0 / 3);
  const double expected = 2 + 5 * t - 5.0 / 3 + constant * std::exp(-rate * t);
  EXPECT_NEAR(relaxed(start, rate, t, 2, 2 + 5 * t), expected, 1e-14);
  EXPECT_NEAR(relaxed(start, 1e-9, t, 2, 4), start, 1e-8); // next to no rate
}

TEST(LayerCircuit, ShortedItChargesThroughTheCore) {
  const LayerCircuit circuit(capacitance, resistance, std::nullopt);
  const double force = 0.3, tau = resistance * capacitance;
  for (const int steps : {1, 7}) {
    const LayerCircuit::State state = held(circuit, force, 0.8 * tau, steps);
    EXPECT_NEAR(state.charge, capacitance * force * (1 - std::exp(-0.8)), 1e-19);
    EXPECT_NEAR(state.rate, force / resistance * std::exp(-0.8), 1e-17);
    EXPECT_EQ(state.voltage, 0);
  }
}

TEST(LayerCircuit, OpenItShowsTheForceAtOnce) {
  const LayerCircuit circuit(capacitance, resistance, circuits::Admittance{});
  const LayerCircuit::State state = held(circuit, 0.3, 1.0, 3);
  EXPECT_EQ(state.charge, 0);
  EXPECT_EQ(state.rate, 0);
  EXPECT_EQ(state.voltage, -0.3);
}

TEST(LayerCircuit, AResistorSlowsItDown) {
  const double load = 2e4;
  const LayerCircuit circuit(capacitance, resistance, circuits::Admittance{load, 0});
  const double force = 0.3, tau = (resistance + load) * capacitance;
  const LayerCircuit::State state = held(circuit, force, tau, 4);
  EXPECT_NEAR(state.charge, capacitance * force * (1 - std::exp(-1.0)), 1e-19);
  EXPECT_NEAR(state.voltage, -load * state.rate, 1e-15);
  EXPECT_NEAR(circuit.start(force).voltage, -force * load / (load + resistance), 1e-15);
}

TEST(LayerCircuit, ACapacitorBesideTheResistorObeysItsEquations) {
  // Against small implicit midpoint steps of R dq/dt = U + S - q/C, dq/dt + C_ext dU/dt = -U/R_ext.
  const double load = 2e4, parallel = 1.5e-6, force = 0.3, duration = 0.05;
  const LayerCircuit circuit(capacitance, resistance, circuits::Admittance{load, parallel});
  double q = 0, u = 0;
  constexpr int steps = 20000;
  const double dt = duration / steps;
  for (int i = 0; i < steps; ++i) {
    const auto rates = [&](double charge, double voltage) {
      const double current = (voltage + force - charge / capacitance) / resistance;
      return std::pair{current, -(voltage / load + current) / parallel};
    };
    const auto [q1, u1] = rates(q, u);
    const auto [q2, u2] = rates(q + 0.5 * dt * q1, u + 0.5 * dt * u1);
    q += dt * q2;
    u += dt * u2;
  }
  for (const int parts : {1, 5}) {
    const LayerCircuit::State state = held(circuit, force, duration, parts);
    EXPECT_NEAR(state.charge, q, 1e-8 * capacitance * force);
    EXPECT_NEAR(state.voltage, u, 1e-8 * force);
  }
}

TEST(LayerCircuit, ATinyParallelCapacitorIsNextToNone) {
  const double force = 0.3, duration = 0.05, load = 2e4;
  const LayerCircuit without(capacitance, resistance, circuits::Admittance{load, 0}),
      with(capacitance, resistance, circuits::Admittance{load, 1e-13});
  EXPECT_NEAR(held(with, force, duration, 3).charge, held(without, force, duration, 3).charge,
              1e-6 * capacitance * force);
}

} // namespace
} // namespace ionskin::electrochemistry
